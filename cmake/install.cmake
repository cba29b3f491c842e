# Installs the libraries, their headers, the program, and the files by which CMake (find_package)
# and pkg-config find them.
include(CMakePackageConfigHelpers)

set(MINKSUM_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/minksum)
set(MINKSUM_COMPONENTS minksum)
if(TARGET minksum_io)
  list(APPEND MINKSUM_COMPONENTS minksum_io)
endif()

if(TARGET minksum_c)
  list(APPEND MINKSUM_COMPONENTS minksum_c)
endif()

install(TARGETS ${MINKSUM_COMPONENTS} EXPORT minksumTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT minksumTargets NAMESPACE minksum:: DESTINATION ${MINKSUM_CMAKE_DIR})

# io.hpp needs minksum_io, and minksum_c.h needs minksum_c.
set(left_out)
if(NOT TARGET minksum_io)
  list(APPEND left_out PATTERN "io.hpp" EXCLUDE)
endif()
if(NOT TARGET minksum_c)
  list(APPEND left_out PATTERN "minksum_c.h" EXCLUDE)
endif()
install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h" ${left_out})
if(TARGET minksum_program)
  install(TARGETS minksum_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/minksumConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/minksumConfig.cmake
  INSTALL_DESTINATION ${MINKSUM_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
# Below 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/minksumConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/package/minksumConfig.cmake
  ${PROJECT_BINARY_DIR}/package/minksumConfigVersion.cmake
  DESTINATION ${MINKSUM_CMAKE_DIR})

# The .pc file has paths relative to itself, so an installation can be moved.
set(pkgconfig_dir ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH MINKSUM_PC_LIBDIR ${pkgconfig_dir} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH MINKSUM_PC_INCLUDEDIR ${pkgconfig_dir} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
set(MINKSUM_PC_LIBRARIES "-lminksum")
if(TARGET minksum_io)
  set(MINKSUM_PC_LIBRARIES "-lminksum_io -lminksum")
endif()
configure_file(cmake/minksum.pc.in ${PROJECT_BINARY_DIR}/package/minksum.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/minksum.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
