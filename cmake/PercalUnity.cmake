# With PERCAL_UNITY the sources of a folder are compiled as one unit: headers and templates are read once a folder, which takes less
# than half of the time, and a change recompiles its folder alone. Names in anonymous namespaces must differ within a folder then.
set(percal_unity_default OFF)
if(CMAKE_BUILD_TYPE STREQUAL Release)
  set(percal_unity_default ON)
endif()
option(PERCAL_UNITY "Compile the sources of a folder as one unit" ${percal_unity_default})

# Called in the folder that defines the targets, when they have all their sources.
function(percal_compile_folders_as_units)
  foreach(target ${ARGN})
    get_target_property(sources ${target} SOURCES)
    foreach(source ${sources})
      get_filename_component(folder ${source} DIRECTORY)
      set(of_folder ${sources})
      list(FILTER of_folder INCLUDE REGEX "^${folder}/[^/]*$")
      list(LENGTH of_folder files)
      if(files EQUAL 1)  # a unit of its own as it is
        continue()
      endif()
      string(MAKE_C_IDENTIFIER "${target}/${folder}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${PERCAL_UNITY} UNITY_BUILD_MODE GROUP)
  endforeach()
endfunction()
