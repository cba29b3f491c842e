# Makes Debian packages of the components: `minksum`, the program with its pages,
# `libminksum-dev`, the libraries, and `postgresql-VERSION-minksum`, the extensions of PostgreSQL if
# they are built. `make package` calls this.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The minksum authors")
# Whoever builds a package for others names himself here.
set(CPACK_PACKAGE_CONTACT "The minksum authors <minksum@example.org>" CACHE STRING
  "Maintainer of the Debian packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program development)
if(TARGET minksum_sql)
  list(APPEND CPACK_COMPONENTS_ALL sql)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME minksum)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libminksum-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(what "minksum computes Minkowski sums, no-fit polygons, offsets, morphology,
penetration depths and configuration spaces of polygons, polylines and
points. All results are exact.")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${what}
This package has the program.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${what}
This package has the static libraries and the headers for C++ and C.")
if(TARGET minksum_sql)
  set(CPACK_DEBIAN_SQL_PACKAGE_NAME postgresql-${MINKSUM_PG_VERSION}-minksum)
  set(CPACK_DEBIAN_SQL_PACKAGE_SECTION database)
  set(CPACK_DEBIAN_SQL_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_SQL_PACKAGE_DEPENDS postgresql-${MINKSUM_PG_VERSION})
  set(CPACK_DEBIAN_SQL_PACKAGE_SUGGESTS postgresql-${MINKSUM_PG_VERSION}-postgis-3)
  set(CPACK_COMPONENT_SQL_DESCRIPTION "${what}
This package has extensions of PostgreSQL, with and without PostGIS.")
endif()

# Debian's policy asks each package for a licence and a changelog under these names. What its checker
# lintian shall not report stands in lintian/PACKAGE, with the reason.
string(TIMESTAMP MINKSUM_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(folder ${PROJECT_BINARY_DIR}/package/${package})
  file(WRITE ${folder}/changelog "${package} (${PROJECT_VERSION}) unstable; urgency=medium

  * CHANGELOG.md has the changes.

 -- ${CPACK_PACKAGE_CONTACT}  ${MINKSUM_PACKAGE_DATE}
")
  install(CODE "execute_process(COMMAND gzip -9nkf ${folder}/changelog
    COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${folder}/changelog.gz DESTINATION share/doc/${package}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES LICENSE DESTINATION share/doc/${package} RENAME copyright COMPONENT ${component}
    EXCLUDE_FROM_ALL)
  if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/lintian/${package})
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/lintian/${package}
      DESTINATION share/lintian/overrides COMPONENT ${component} EXCLUDE_FROM_ALL)
  endif()
endforeach()
include(CPack)
