# The Python module `percal` (lib/python), built where Python 3.10 or later with its headers, and pybind11, are found. Another Python
# than the one found: -DPython3_EXECUTABLE=/path/to/python3. Not at all: -DPERCAL_PYTHON=OFF. What is
# missing today may be there at the next configuration, so AUTO is asked again each time.

# The Python of an active virtual environment, else Debian's own, whose headers and numpy come in packages, else the first in PATH.
function(percal_choose_python)
  set(has_headers_and_numpy
      "import numpy, os, sysconfig; os.stat(os.path.join(sysconfig.get_path('include'), 'Python.h'))")
  foreach(candidate "$ENV{VIRTUAL_ENV}/bin/python3" /usr/bin/python3 python3)
    execute_process(COMMAND ${candidate} -c "${has_headers_and_numpy}" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if(status EQUAL 0)
      execute_process(COMMAND ${candidate} -c "import sys; print(sys.executable)" OUTPUT_VARIABLE path
                      OUTPUT_STRIP_TRAILING_WHITESPACE)
      set(Python3_EXECUTABLE ${path} CACHE FILEPATH "The Python that the module is built for")
      return()
    endif()
  endforeach()
endfunction()

set(PERCAL_PYTHON AUTO CACHE STRING "Build the Python module: ON, OFF, AUTO (where what it takes is there)")
set(percal_python ${PERCAL_PYTHON})
# Without sanitizers: their runtime would have to be loaded before Python.
if(PERCAL_PYTHON STREQUAL AUTO AND CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(percal_python OFF)
  message(STATUS "percal: no Python module by default in a build with sanitizers")
elseif(PERCAL_PYTHON STREQUAL AUTO)
  set(percal_python ${PROJECT_IS_TOP_LEVEL})
endif()
if(percal_python)
  if(NOT Python3_EXECUTABLE)
    percal_choose_python()
  endif()
  find_package(Python3 3.10 QUIET COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 CONFIG QUIET)
  set(missing "")
  if(NOT Python3_Development.Module_FOUND)
    list(APPEND missing "Python 3.10 with headers and numpy (python3-dev, python3-numpy)")
  endif()
  if(NOT pybind11_FOUND)
    list(APPEND missing "pybind11 2.10 (pybind11-dev)")
  endif()
  if(missing)
    list(JOIN missing ", " missing)
    if(NOT PERCAL_PYTHON STREQUAL AUTO)
      message(FATAL_ERROR "PERCAL_PYTHON is on, but there is no ${missing}")
    endif()
    message(STATUS "percal: no Python module, missing: ${missing}; sh tools/setup.sh python, then configure again")
    set(percal_python OFF)
  endif()
endif()
if(NOT percal_python)
  return()
endif()

# Where `import percal` finds it in an installed tree, below the prefix: /usr/lib/python3/dist-packages on Debian.
set(PERCAL_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Folder of the Python module below the prefix")
message(STATUS "percal: Python module for ${Python3_EXECUTABLE} ${Python3_VERSION}, installed in ${PERCAL_PYTHON_DIR}")

set_target_properties(percal percal_text PROPERTIES POSITION_INDEPENDENT_CODE ON)
foreach(part percal percal_text)
  target_compile_options(${part} PRIVATE -fno-semantic-interposition)  # functions stay as easy to inline as without
endforeach()
add_subdirectory(lib/python)
