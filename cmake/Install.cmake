# `cmake --install`: the program, the library with its headers and CMake package, and the schema of
# scene files.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS calotype RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS calotype_engine EXPORT calotypeTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${CMAKE_BINARY_DIR}/include/calotype DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES scenes/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/calotype)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/calotype)
configure_package_config_file(cmake/calotypeConfig.cmake.in
                              ${CMAKE_BINARY_DIR}/package/calotypeConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/calotypeConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/package/calotypeConfig.cmake
              ${CMAKE_BINARY_DIR}/package/calotypeConfigVersion.cmake
        DESTINATION ${package_dir})
install(EXPORT calotypeTargets NAMESPACE calotype:: DESTINATION ${package_dir})
