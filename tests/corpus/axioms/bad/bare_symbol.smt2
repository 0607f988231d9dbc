leads
