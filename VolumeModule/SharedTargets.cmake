# How targets are built, and the targets that all of them link to, for every project that builds the
# module: the one of this tree and those for programs with a VTK of their own. VTK must have been found.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
# Libraries export only symbols with an export macro, as those of VTK do.
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
# The module is a shared library, so that the plugin, the programs and Python load the same one.
set(BUILD_SHARED_LIBS ON)

add_library(VarimarchBuildOptions INTERFACE)
target_compile_options(VarimarchBuildOptions INTERFACE -Wall -Wextra
  $<$<BOOL:${VARIMARCH_WARNINGS_AS_ERRORS}>:-Werror>)
# A unity build includes the files of a target. GCC takes them for headers and warns of classes there
# that have a member or base from an anonymous namespace.
target_compile_options(VarimarchBuildOptions INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
# This option lets ccache store compilations with precompiled headers.
target_compile_options(VarimarchBuildOptions INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
# Hardening, in this place only: programs from source and packages are built alike, and a test reads
# it from the binaries. Sanitizers replace it.
include(CheckPIESupported)
check_pie_supported()
add_library(VarimarchHardening INTERFACE)
target_link_libraries(VarimarchBuildOptions INTERFACE VarimarchHardening)
if(NOT VARIMARCH_SANITIZE)
  target_compile_options(VarimarchHardening INTERFACE
    -fstack-protector-strong -fstack-clash-protection
    # Some compilers define it already, and it needs optimisation.
    $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE> $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=2>)
  # Checked indices and iterators of the standard library, where data of strangers is read. Core,
  # whose inner loops they would slow down, undefines it.
  target_compile_definitions(VarimarchHardening INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(VarimarchHardening INTERFACE -Wl,-z,relro,-z,now)
endif()
# The functions of OpenGL as VTK has loaded them: by GLEW up to VTK 9.3, by glad since 9.4.
add_library(VarimarchOpenGL INTERFACE)
foreach(module IN ITEMS opengl glew glad)
  if(TARGET VTK::${module})
    target_link_libraries(VarimarchOpenGL INTERFACE VTK::${module})
  endif()
endforeach()
