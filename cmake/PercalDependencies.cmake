# Every package that percal needs, in one place. Debian's names are in tools/packages.txt.
find_package(Threads REQUIRED)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(Ceres 2 REQUIRED)
find_package(GSL REQUIRED)
find_package(nlohmann_json 3 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(pugixml REQUIRED)
find_package(NLopt CONFIG QUIET PATHS /usr/lib/x86_64-linux-gnu/cmake/nlopt_cxx NO_DEFAULT_PATH)
if(NOT NLopt_FOUND)
  find_package(NLopt CONFIG REQUIRED)
endif()
find_path(TOMLPLUSPLUS_INCLUDE toml++/toml.h REQUIRED)

add_library(percal_dependencies INTERFACE)
target_include_directories(percal_dependencies SYSTEM INTERFACE ${TOMLPLUSPLUS_INCLUDE})
target_link_libraries(percal_dependencies INTERFACE
  Ceres::ceres GSL::gsl GSL::gslcblas Eigen3::Eigen SQLite::SQLite3 ZLIB::ZLIB OpenSSL::Crypto pugixml::pugixml
  $<IF:$<TARGET_EXISTS:NLopt::nlopt_cxx>,NLopt::nlopt_cxx,NLopt::nlopt>)
