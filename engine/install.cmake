# What `make install` and packages contain. The folders are those of the build tree, so that the program finds its
# data and modules relative to itself in both.
#   bin/flyrock   lib/flyrock: native plugins, and the archive for others   include/flyrock: the headers of plugins
#   lib/cmake/flyrock: find_package(flyrock)   share/flyrock: manifests, Lua, report, course, schema   share/doc/flyrock
#   share/man, share/bash-completion, share/zsh: what the program says of itself

# The floors below the plugins in one archive.
set(plugin_floors math random units geometry blast plugin)
add_library(flyrock_plugin_archive STATIC)
foreach(floor ${plugin_floors})
  get_target_property(type flyrock_${floor} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    target_sources(flyrock_plugin_archive PRIVATE $<TARGET_OBJECTS:flyrock_${floor}>)
  endif()
endforeach()
set_target_properties(flyrock_plugin_archive PROPERTIES OUTPUT_NAME flyrock_plugin LINKER_LANGUAGE CXX
  ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/flyrock)

# What a plugin includes, and all that this includes.
set(headers)
set(unread plugin/module.h plugin/pivoting.h geometry/hull.h)
while(unread)
  list(POP_FRONT unread header)
  if(NOT header IN_LIST headers)
    list(APPEND headers ${header})
    file(STRINGS ${PROJECT_SOURCE_DIR}/engine/${header} lines REGEX "^#include \"")
    list(TRANSFORM lines REPLACE "^#include \"([^\"]+)\".*" "\\1")
    list(APPEND unread ${lines})
  endif()
endwhile()

install(TARGETS flyrock RUNTIME DESTINATION bin COMPONENT flyrock)
install(TARGETS flyrock_plugins LIBRARY DESTINATION lib/flyrock COMPONENT flyrock)
if(TARGET flyrock_gdal)
  install(TARGETS flyrock_gdal LIBRARY DESTINATION lib/flyrock COMPONENT gdal)
endif()
install(TARGETS flyrock_plugin_archive ARCHIVE DESTINATION lib/flyrock COMPONENT flyrock)
install(DIRECTORY ${CMAKE_BINARY_DIR}/share/flyrock DESTINATION share COMPONENT flyrock
  PATTERN ".stamp" EXCLUDE PATTERN "*.so" EXCLUDE)
set(descriptions ${CMAKE_BINARY_DIR}/descriptions)
add_custom_command(
  OUTPUT ${descriptions}/.stamp
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:flyrock> -DFOLDER=${descriptions}
    -P ${PROJECT_SOURCE_DIR}/engine/describe.cmake
  DEPENDS flyrock flyrock_plugins ${CMAKE_BINARY_DIR}/share/flyrock/.stamp ${PROJECT_SOURCE_DIR}/engine/describe.cmake
  COMMENT "Writing manual pages, completions and the schema")
add_custom_target(flyrock_descriptions ALL DEPENDS ${descriptions}/.stamp)
install(DIRECTORY ${descriptions}/share DESTINATION . COMPONENT flyrock)
foreach(header ${headers})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/engine/${header} DESTINATION include/flyrock/${folder} COMPONENT flyrock)
endforeach()
foreach(page README.md LICENSE CHANGELOG.md CITATION.cff CONTRIBUTING.md)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION share/doc/flyrock COMPONENT flyrock)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION share/doc/flyrock/docs COMPONENT flyrock
  FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png" PATTERN "*.cff")
# Pages link to scenarios as in the sources.
file(CREATE_LINK ../../flyrock/scenarios ${CMAKE_BINARY_DIR}/scenarios SYMBOLIC)
install(FILES ${CMAKE_BINARY_DIR}/scenarios DESTINATION share/doc/flyrock COMPONENT flyrock)
# The licences of what is compiled in, and of what the reports contain.
foreach(package libeigen3-dev librandom123-dev nlohmann-json3-dev libboost-dev libtinyobjloader-dev libfmt-dev)
  install(CODE "file(REAL_PATH /usr/share/doc/${package} pages)
    if(EXISTS \${pages}/copyright)
      file(INSTALL \${pages}/copyright DESTINATION \${CMAKE_INSTALL_PREFIX}/share/doc/flyrock/licences RENAME ${package})
    else()
      message(WARNING \"/usr/share/doc/${package} has no copyright: what is installed lacks its licence\")
    endif()" COMPONENT flyrock)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/node_modules/plotly.js-gl3d-dist-min/LICENSE
  DESTINATION share/doc/flyrock/licences COMPONENT flyrock RENAME plotly.js OPTIONAL)

include(CMakePackageConfigHelpers)
string(REPLACE " " ";" plugin_options "${plugin_flags}")
configure_package_config_file(${PROJECT_SOURCE_DIR}/engine/flyrock-config.cmake.in
  ${CMAKE_BINARY_DIR}/flyrock-config.cmake INSTALL_DESTINATION lib/cmake/flyrock)
# A module must have the version of the program.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/flyrock-config-version.cmake COMPATIBILITY ExactVersion)
install(FILES ${CMAKE_BINARY_DIR}/flyrock-config.cmake ${CMAKE_BINARY_DIR}/flyrock-config-version.cmake
  DESTINATION lib/cmake/flyrock COMPONENT flyrock)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME flyrock)
set(CPACK_PACKAGE_CONTACT "the flyrock developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulates blast fly-rock and rockfall by non-smooth contact dynamics")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FLYROCK_PACKAGE_NAME flyrock)
set(CPACK_DEBIAN_FLYROCK_PACKAGE_SUGGESTS "flyrock-gdal, g++, cmake, libeigen3-dev, libfmt-dev")
# Rasters in the formats of GDAL, apart because GDAL brings a hundred packages.
set(CPACK_DEBIAN_GDAL_PACKAGE_NAME flyrock-gdal)
set(CPACK_DEBIAN_GDAL_PACKAGE_DEPENDS "flyrock (= ${PROJECT_VERSION})")
set(CPACK_COMPONENTS_ALL flyrock)
if(TARGET flyrock_gdal)
  list(APPEND CPACK_COMPONENTS_ALL gdal)
endif()
include(CPack)
