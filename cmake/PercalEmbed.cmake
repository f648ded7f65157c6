# percal_embed(TARGET FOLDER): makes every file below a folder of sources part of a program, as text by its name in that folder. It
# defines embedded_templates() of tools/templates.hpp.
function(percal_embed target folder)
  file(GLOB_RECURSE names RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/${folder} CONFIGURE_DEPENDS ${folder}/*)
  set(PERCAL_EMBEDDED "")
  foreach(name ${names})
    file(READ ${folder}/${name} text)
    string(APPEND PERCAL_EMBEDDED "    {\"${name}\", R\"percal(${text})percal\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/${name})
  endforeach()
  file(CONFIGURE OUTPUT embedded_${folder}.cpp @ONLY CONTENT [[
#include "@CMAKE_CURRENT_SOURCE_DIR@/templates.hpp"

const std::map<std::string, std::string>& percal::tools::embedded_templates() {
  static const std::map<std::string, std::string> files{
@PERCAL_EMBEDDED@  };
  return files;
}
]])
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded_${folder}.cpp)
endfunction()
