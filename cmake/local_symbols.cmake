# Fails if one of OBJECTS defines a symbol that the linker may share between files: then code for one
# kind of processor could end up in the whole program. Called with -DNM=... -DOBJECTS=a;b.
foreach(object ${OBJECTS})
  execute_process(COMMAND ${NM} --defined-only ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]* [VWuiv] [^\n]*" shared "${symbols}")
  list(FILTER shared EXCLUDE REGEX "DW\\.ref")
  string(REGEX MATCHALL "[^\n]* T [^\n]*" global "${symbols}")
  list(LENGTH global count)
  if(shared OR NOT count EQUAL 1)
    message(FATAL_ERROR "${object}: one global function expected, found ${count}; shared: ${shared}")
  endif()
endforeach()
