#ifndef Varimarch_VtkVersions_h
#define Varimarch_VtkVersions_h

// The differences between the versions of VTK that the module is built with, 9.1 to 9.7. No other
// file asks for the version.

// The functions of OpenGL: GLEW's up to VTK 9.3, glad's since 9.4.
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <string>

namespace varimarch
{

/// A function that gives the address of one of OpenGL's functions.
using OpenGLLoader = void (*(*)(const char* name))();

/// Loads the functions of OpenGL for the current context, which needs no display.
/// @return the fault; empty if there was none
#if __has_include("vtk_glad.h")
inline std::string LoadOpenGL(OpenGLLoader loader)
{
  return gladLoadGL(loader) > 0 ? std::string() : "glad found no OpenGL";
}
#else
inline std::string LoadOpenGL(OpenGLLoader)
{
  // GLEW returns this if it has loaded all functions but found no GLX display. EGL never has one.
  constexpr GLenum ErrorNoGLXDisplay = 4;
  const GLenum result = glewInit();
  const bool isLoaded = result == GLEW_OK || result == ErrorNoGLXDisplay;
  return isLoaded ? std::string() : reinterpret_cast<const char*>(glewGetErrorString(result));
}
#endif

}

// Tells a vtkOpenGLRenderWindow, in one of its methods, whether the functions are loaded.
#if __has_include("vtk_glad.h")
#define VARIMARCH_SET_OPENGL_LOADED(isLoaded) ((void)(isLoaded))
#else
#define VARIMARCH_SET_OPENGL_LOADED(isLoaded) (this->GlewInitValid = (isLoaded))
#endif

#endif
