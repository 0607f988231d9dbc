#include "engine/minimal/identified_arms.hpp"

#include <algorithm>

namespace asterism {

void IdentifiedArms::reset() {
  above_.assign(table_.visits(), no_arm);
  visits_there_.assign(table_.visits(), 1);
  across_.assign(table_.size(), no_arm);
  done_.clear();
  narrowed_.clear();

  std::vector<std::uint64_t> none_alike(words_, 0);
  IdVector<ViewId, std::vector<std::uint64_t>> alike(table_.views(), none_alike);
  for (const ArmId arm : table_.all_arms()) alike[table_.view(arm)][word_of(arm)] |= bit_of(arm);
  may_be_.clear();
  may_be_.reserve(table_.size() * words_);
  for (const ArmId arm : table_.all_arms()) {
    const std::vector<std::uint64_t>& may_be = alike[table_.view(arm)];
    may_be_.insert(may_be_.end(), may_be.begin(), may_be.end());
  }
}

void IdentifiedArms::know(const IdentifiedArms& shorter) {
  const ArmId later(shorter.across_.size());
  const std::size_t last = shorter.words_ - 1;
  for (const ArmId arm : IdRange(ArmId(0), later)) {
    const std::uint64_t* const known = shorter.row(arm);
    for (std::size_t w = 0; w < last; ++w) row(arm)[w] &= known[w];
    row(arm)[last] &= known[last] | (word_of(later) == last ? ~(bit_of(later) - 1) : 0);
  }
}

void IdentifiedArms::forbid(ArmId x, ArmId y) {
  for (std::uint32_t step = 0; step < table_.star_size(table_.visit_of(x)); ++step) {
    const ArmId a = table_.clockwise(x, step);
    const ArmId b = table_.clockwise(y, step);
    row(a)[word_of(b)] &= ~bit_of(b);
    row(b)[word_of(a)] &= ~bit_of(a);
  }
}

void IdentifiedArms::keep() {
  done_.clear();
  narrowed_.clear();
  narrowed_.shrink_to_fit();
}

void IdentifiedArms::narrow(ArmId arm, ArmId other) {
  std::uint64_t* const own = row(arm);
  const std::uint64_t* const others = row(other);
  narrowed_.insert(narrowed_.end(), own, own + words_);
  done_.push_back({Done::Kind::narrowed, arm, no_arm});
  for (std::size_t w = 0; w < words_; ++w) own[w] &= others[w];
}

bool IdentifiedArms::undo(Mark mark) {
  if (done_.size() <= mark) return false;
  while (done_.size() > mark) {
    const Done last = done_.back();
    done_.pop_back();
    switch (last.kind) {
      case Done::Kind::united: {
        const VisitId went = table_.visit_of(last.arm);
        above_[went] = no_arm;
        visits_there_[table_.visit_of(last.other)] -= visits_there_[went];
        break;
      }
      case Done::Kind::joined:
        across_[last.arm] = no_arm;
        break;
      case Done::Kind::narrowed:
        std::copy(narrowed_.end() - static_cast<std::ptrdiff_t>(words_), narrowed_.end(),
                  row(last.arm));
        narrowed_.resize(narrowed_.size() - words_);
        break;
    }
  }
  return true;
}

std::size_t IdentifiedArms::memory_bytes() const {
  return (may_be_.capacity() + narrowed_.capacity()) * sizeof(std::uint64_t) +
         done_.capacity() * sizeof(Done);
}

}  // namespace asterism
