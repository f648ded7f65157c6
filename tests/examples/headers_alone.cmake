# Compiles every header by itself.
# cmake "-DHEADERS=percal/fit.hpp;..." -DCXX=... -DINCLUDE=... -DEIGEN=... -P headers_alone.cmake
foreach(header ${HEADERS})
  execute_process(COMMAND ${CXX} -std=c++20 -Wall -Wextra -fsyntax-only -x c++ -include ${header} -I${INCLUDE}
                          -isystem ${EIGEN} /dev/null
                  RESULT_VARIABLE status ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(SEND_ERROR "${header} does not compile alone:\n${errors}")
  endif()
endforeach()
