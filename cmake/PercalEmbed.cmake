# percal_embed(TARGET FUNCTION HEADER FOLDER NAMES...): makes files of a folder of sources part of a target, as text by their names in that
# folder: FUNCTION() of HEADER gives them all.
function(percal_embed target function header folder)
  set(PERCAL_EMBEDDED "")
  foreach(name ${ARGN})
    file(READ ${folder}/${name} text)
    string(APPEND PERCAL_EMBEDDED "    {\"${name}\", R\"percal(${text})percal\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/${name})
  endforeach()
  get_filename_component(PERCAL_EMBED_HEADER ${header} ABSOLUTE)
  set(PERCAL_EMBED_FUNCTION ${function})
  string(MAKE_C_IDENTIFIER ${function} id)
  file(CONFIGURE OUTPUT embedded_${id}.cpp @ONLY CONTENT [[
#include "@PERCAL_EMBED_HEADER@"

const std::map<std::string, std::string>& @PERCAL_EMBED_FUNCTION@() {
  static const std::map<std::string, std::string> files{
@PERCAL_EMBEDDED@  };
  return files;
}
]])
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded_${id}.cpp)
endfunction()
