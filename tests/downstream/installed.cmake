# Installs percal into a fresh prefix, builds tests/downstream/program against it and runs it.
# cmake -DBUILD=... -DSOURCE=... -DWORK=... -DGENERATOR=... -DCXX=... -DCXX_FLAGS=... -DCONFIG=... -P installed.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\n${output}\nended with ${status}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --config "${CONFIG}")
# Moved afterwards: the package must not remember where it was installed.
file(RENAME ${WORK}/prefix ${WORK}/moved)
run(${CMAKE_COMMAND} -S ${SOURCE}/program -B ${WORK}/build -G "${GENERATOR}" -DCMAKE_CXX_COMPILER=${CXX}
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_PREFIX_PATH=${WORK}/moved)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/downstream)
# MU1 = 2 * 1.2 MPa / 3
if(NOT output MATCHES "\n       0\\.8 ")
  message(FATAL_ERROR "the card of the downstream program has no MU1 of 0.8 MPa:\n${output}")
endif()
run(${WORK}/build/fit ${WORK}/moved/share/percal/data/synthetic/gelatin_12wt_quasistatic.csv)
if(NOT output MATCHES "mu 11[0-9][0-9][0-9] Pa")
  message(FATAL_ERROR "the example fit, built downstream, says: ${output}")
endif()
run(${WORK}/moved/bin/percal --version)
if(NOT output MATCHES "^percal [0-9]+\\.[0-9]+\\.[0-9]+")
  message(FATAL_ERROR "the installed program says: ${output}")
endif()
file(REMOVE_RECURSE ${WORK})
