# Runs COMMAND and compares what it prints with the file EXPECTED.
execute_process(COMMAND ${COMMAND} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${EXPECTED} expected)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "${COMMAND}: found\n${printed}expected\n${expected}")
endif()
