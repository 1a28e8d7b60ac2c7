# A port of the tree that it lies in: vcpkg install libsf --overlay-ports=libsf/package/vcpkg
# In a registry SOURCE_PATH would come from vcpkg_from_github() or its like; the rest would stay.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../.." ABSOLUTE)

set(options -Ddemo=false -Dtests=false -Dauto_features=disabled)
if("png" IN_LIST FEATURES)
  list(APPEND options -Dpng=enabled -Djson=enabled)
endif()
if("hdf5" IN_LIST FEATURES)
  list(APPEND options -Dhdf5=enabled)
endif()

vcpkg_configure_meson(SOURCE_PATH "${SOURCE_PATH}" OPTIONS ${options})
vcpkg_install_meson()
vcpkg_copy_pdbs()
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/lib/cmake")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")

# libsfConfig.cmake finds the library two folders up, and its other half lies beside it: both stay in
# lib/cmake/libsf, where find_package() looks as well as in share.
set(VCPKG_POLICY_SKIP_MISPLACED_CMAKE_FILES_CHECK enabled)
set(VCPKG_POLICY_SKIP_LIB_CMAKE_MERGE_CHECK enabled)
