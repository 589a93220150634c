#include "March/Device/FilterPrecision.h"

#include "Core/Recipe/ShaderAssembly.h"
#include "March/Device/ShaderFiles.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/VolumeTexture.h"
#include "VtkVersions.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

constexpr Viewport ProbedPixels = { 0, 0, 64, 1 };

// Eight voxels that use all bits, some next to very different ones.
vtkNew<vtkUnsignedCharArray> ProbedVoxels()
{
  vtkNew<vtkUnsignedCharArray> voxels;
  for (const unsigned char voxel : { 0, 255, 85, 171, 254, 1, 128, 51 })
  {
    voxels->InsertNextValue(voxel);
  }
  return voxels;
}

void DrawDifferences(
  vtkOpenGLRenderWindow* window, const VolumeTexture& narrow, const VolumeTexture& wide)
{
  const std::string source = AssembleShader(LoadShaderFiles({ "FilterDifference.frag.glsl" }));
  vtkOpenGLQuadHelper image(window, nullptr, source.c_str(), "");
  if (!image.Program)
  {
    throw std::runtime_error("Cannot compile the shader FilterDifference.frag.glsl");
  }
  narrow.Texture()->Activate();
  wide.Texture()->Activate();
  image.Program->SetUniformi("narrowTexture", narrow.Texture()->GetTextureUnit());
  image.Program->SetUniformi("wideTexture", wide.Texture()->GetTextureUnit());
  image.Render();
  narrow.Texture()->Deactivate();
  wide.Texture()->Deactivate();
}

std::string NameOfDevice()
{
  std::string name;
  for (const GLenum part : { GL_VENDOR, GL_RENDERER, GL_VERSION })
  {
    const auto* const text = reinterpret_cast<const char*>(glGetString(part));
    name += text ? text : "";
    name += '\n';
  }
  return name;
}

}

double LargestFilterDifference(vtkOpenGLRenderWindow* window)
{
  const vtkNew<vtkUnsignedCharArray> voxels = ProbedVoxels();
  const VoxelComponents components = { { voxels, 0 } };
  const std::vector<ScalarTexels> texels = ScalarTexelsOf(components);
  const ScalarRegion all = { components, glm::ivec3(2), { glm::ivec3(0), glm::ivec3(2) } };
  VolumeTexture narrow;
  VolumeTexture wide;
  FloatFramebuffer target;
  vtkOpenGLState* const state = window->GetState();
  state->Push();
  for (const GLenum test : { GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE })
  {
    state->vtkglDisable(test);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  narrow.Upload(window, all, texels, TexelFormat::Integers8);
  wide.Upload(window, all, texels, TexelFormat::Integers16);
  target.Draw(window, ProbedPixels, [&] { DrawDifferences(window, narrow, wide); });
  state->Pop();
  double largest = 0.0;
  for (const float difference : target.Read(window, ProbedPixels))
  {
    largest = std::max(largest, double(std::abs(difference)));
  }
  narrow.Release(window);
  wide.Release(window);
  target.Release(window);
  return largest;
}

// A difference of 1/64 of a grey level is the least that gradients, as differences between voxels
// a few levels apart, do not show.
bool Filters8BitsExactly(vtkOpenGLRenderWindow* window)
{
  constexpr double MostDifference = 1.0 / (64.0 * 255.0);
  static std::mutex access;
  static std::map<std::string, bool> exactDevices;
  const std::lock_guard<std::mutex> lock(access);
  const std::string device = NameOfDevice();
  const auto known = exactDevices.find(device);
  if (known != exactDevices.end())
  {
    return known->second;
  }
  const bool isExact = LargestFilterDifference(window) <= MostDifference;
  exactDevices[device] = isExact;
  return isExact;
}

}
