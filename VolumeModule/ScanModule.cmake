# Finds the module for vtk_module_build(): varimarch_modules lists it. SharedTargets.cmake and Core come
# first.
vtk_module_scan(
  MODULE_FILES "${CMAKE_CURRENT_LIST_DIR}/vtk.module"
  PROVIDES_MODULES varimarch_modules
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)
