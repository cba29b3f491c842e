# Installs the program with its man pages, completions and pages (component `program`); and the
# libraries, their headers, and the files by which CMake (find_package) and pkg-config find them
# (component `development`).
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
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT program NAMELINK_COMPONENT development
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(EXPORT minksumTargets NAMESPACE minksum:: DESTINATION ${MINKSUM_CMAKE_DIR}
  COMPONENT development)

# io.hpp needs minksum_io, and minksum_c.h needs minksum_c.
set(left_out)
if(NOT TARGET minksum_io)
  list(APPEND left_out PATTERN "io.hpp" EXCLUDE)
endif()
if(NOT TARGET minksum_c)
  list(APPEND left_out PATTERN "minksum_c.h" EXCLUDE)
endif()
install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h" ${left_out})
if(TARGET minksum_program)
  install(TARGETS minksum_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  # The program makes its man pages and completions. A program for another machine cannot.
  if(NOT CMAKE_CROSSCOMPILING)
    set(MINKSUM_SHARE ${PROJECT_BINARY_DIR}/package/share)
    find_program(MINKSUM_GZIP gzip)
    install(CODE "
      file(REMOVE_RECURSE ${MINKSUM_SHARE})
      execute_process(COMMAND $<TARGET_FILE:minksum_program> help --install ${MINKSUM_SHARE}
        COMMAND_ERROR_IS_FATAL ANY)
      file(GLOB pages ${MINKSUM_SHARE}/man/man1/*.1)
      if(EXISTS \"${MINKSUM_GZIP}\")
        execute_process(COMMAND ${MINKSUM_GZIP} -9n \${pages} COMMAND_ERROR_IS_FATAL ANY)
      endif()" COMPONENT program)
    install(DIRECTORY ${MINKSUM_SHARE}/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT program)
  endif()
endif()
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
  FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.wkt")
# Debian packages have it under another name (package.cmake).
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)

configure_package_config_file(cmake/minksumConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/minksumConfig.cmake
  INSTALL_DESTINATION ${MINKSUM_CMAKE_DIR} NO_SET_AND_CHECK_MACRO)
# Below 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/minksumConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/package/minksumConfig.cmake
  ${PROJECT_BINARY_DIR}/package/minksumConfigVersion.cmake
  DESTINATION ${MINKSUM_CMAKE_DIR} COMPONENT development)

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
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
