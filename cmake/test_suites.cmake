# Writes the file that tells ctest of a test program: one entry for each of its suites. A program
# takes 0.4 s to load its libraries, longer than most tests take.
#   cmake -DPROGRAM=... -DLEFT_OUT=REGEX -DOUTPUT=... -P test_suites.cmake
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[^ \n]+\\.( +#[^\n]*)?\n" suites "${listed}")
set(entries "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "^\n|\\.[ \n].*" "" suite "${suite}")
  if(LEFT_OUT AND suite MATCHES "${LEFT_OUT}")
    continue()
  endif()
  string(APPEND entries "add_test([=[${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*]=])\n"
    "set_tests_properties([=[${suite}]=] PROPERTIES TIMEOUT 600)\n")
endforeach()
file(WRITE ${OUTPUT} "${entries}")
