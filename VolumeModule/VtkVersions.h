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

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkInformation.h"
#include "vtkOpenGLActor.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

// The mapper of polygons in blocks.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
#else
#include "vtkCompositePolyDataMapper2.h"
#endif

#include <string>

namespace varimarch
{

/// The mean cosine of the angle by which matter turns light, [-1, 1]; 0 before VTK 9.2.
inline double ScatteringAnisotropyOf(vtkVolumeProperty* property)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  return property->GetScatteringAnisotropy();
#else
  (void)property;
  return 0.0;
#endif
}

/// Copies the blending of scattered light and the reach of global illumination; since VTK 9.2.
/// @param to  any class with these settings; they stay as they are before VTK 9.2
template <class Mapper>
void CopyScattering(vtkGPUVolumeRayCastMapper* from, Mapper* to)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  to->SetVolumetricScatteringBlending(from->GetVolumetricScatteringBlending());
  to->SetGlobalIlluminationReach(from->GetGlobalIlluminationReach());
#else
  (void)from;
  (void)to;
#endif
}

/// True if the normals of light are those of the opacity instead of the scalars; since VTK 9.2.
inline bool ShadesByOpacity(vtkVolumeMapper* mapper)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  return mapper->GetComputeNormalFromOpacity();
#else
  (void)mapper;
  return false;
#endif
}

/// Copies the setting that ShadesByOpacity returns.
inline void CopyShadingByOpacity(vtkVolumeMapper* from, vtkVolumeMapper* to)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  to->SetComputeNormalFromOpacity(from->GetComputeNormalFromOpacity());
#else
  (void)from;
  (void)to;
#endif
}

/// True if the volume shall write to the depth buffer, for passes such as ambient occlusion in
/// screen space; since VTK 9.4.
inline bool WritesDepth(vtkVolume* volume)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  vtkInformation* const keys = volume->GetPropertyKeys();
  return keys && keys->Has(vtkOpenGLActor::GLDepthMaskOverride()) &&
    keys->Get(vtkOpenGLActor::GLDepthMaskOverride()) == 1;
#else
  (void)volume;
  return false;
#endif
}

/// The mapper of polygons in blocks whose visibility and colour can be set.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
using BlockMapper = vtkCompositePolyDataMapper;
#else
using BlockMapper = vtkCompositePolyDataMapper2;
#endif

/// The visibility and the colours of a mapper's blocks; null if it has none.
inline vtkCompositeDataDisplayAttributes* BlockAttributesOf(vtkMapper* mapper)
{
  auto* const ofBlocks = BlockMapper::SafeDownCast(mapper);
  return ofBlocks ? ofBlocks->GetCompositeDataDisplayAttributes() : nullptr;
}

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
