# cmake -DLIBRARY=... -DNM=... -P public_names.cmake
# Fails if the shared library exports functions that no public header declares.
execute_process(COMMAND ${NM} -DC --defined-only ${LIBRARY}
  OUTPUT_VARIABLE names RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} failed")
endif()
string(REGEX MATCHALL "[^\n]* T [^\n]*" functions "${names}")
list(LENGTH functions count)
if(count LESS 100)
  message(FATAL_ERROR "only ${count} functions are shown")
endif()
foreach(function IN LISTS functions)
  if(NOT function MATCHES " T (.* )?minksum::" OR
     function MATCHES "Access::|signed_sum::|overlay::|ExactKernel|Cancellation|prepare_operand")
    message(SEND_ERROR "shown, and not public: ${function}")
  endif()
endforeach()
