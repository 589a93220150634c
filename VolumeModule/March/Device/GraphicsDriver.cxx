#include "March/Device/GraphicsDriver.h"

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
#include <functional>
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

void DrawDifferences(vtkOpenGLRenderWindow* window, const VolumeTexture& filtered,
  const std::string& filter, const VolumeTexture& wide)
{
  const std::string source =
    AssembleShader(LoadShaderFiles({ filter, "FilterDifference.frag.glsl" }));
  vtkOpenGLQuadHelper image(window, nullptr, source.c_str(), "");
  if (!image.Program)
  {
    throw std::runtime_error("Cannot compile the shader FilterDifference.frag.glsl");
  }
  filtered.Texture()->Activate();
  wide.Texture()->Activate();
  image.Program->SetUniformi("filteredTexture", filtered.Texture()->GetTextureUnit());
  image.Program->SetUniformi("wideTexture", wide.Texture()->GetTextureUnit());
  image.Render();
  filtered.Texture()->Deactivate();
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

// The largest difference between the same voxels in a texture that a file of Filter/ filters and in
// one of 16 bits that the device filters, as a fraction of the largest texel.
double LargestDifference(vtkOpenGLRenderWindow* window, TexelFormat format, const char* filter)
{
  const vtkNew<vtkUnsignedCharArray> voxels = ProbedVoxels();
  const VoxelComponents components = { { voxels, 0 } };
  const std::vector<ScalarTexels> texels = ScalarTexelsOf(components);
  const ScalarRegion all = { components, glm::ivec3(2), { glm::ivec3(0), glm::ivec3(2) } };
  VolumeTexture filtered;
  VolumeTexture wide;
  FloatFramebuffer target;
  vtkOpenGLState* const state = window->GetState();
  state->Push();
  for (const GLenum test : { GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE })
  {
    state->vtkglDisable(test);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  filtered.Upload(window, all, texels, format);
  wide.Upload(window, all, texels, TexelFormat::Integers16);
  target.Draw(window, ProbedPixels, [&] { DrawDifferences(window, filtered, filter, wide); });
  state->Pop();
  double largest = 0.0;
  for (const float difference : target.Read(window, ProbedPixels))
  {
    largest = std::max(largest, double(std::abs(difference)));
  }
  filtered.Release(window);
  wide.Release(window);
  target.Release(window);
  return largest;
}

// A property of devices, each of which is measured once.
class PropertyOfDevices
{
public:
  bool OfCurrent(const std::function<bool()>& measure)
  {
    const std::lock_guard<std::mutex> lock(this->access);
    const std::string device = NameOfDevice();
    const auto known = this->values.find(device);
    return known != this->values.end() ? known->second
                                       : this->values.emplace(device, measure()).first->second;
  }

private:
  std::mutex access;
  std::map<std::string, bool> values;
};

}

double LargestNarrowDifference(vtkOpenGLRenderWindow* window)
{
  return LargestDifference(window, TexelFormat::Integers8, "Filter/OfDevice.glsl");
}

double LargestWeightDifference(vtkOpenGLRenderWindow* window)
{
  return LargestDifference(window, TexelFormat::Integers16, "Filter/OfTexels.glsl");
}

// A difference of 1/64 of a grey level is the least that gradients, as differences between voxels
// a few levels apart, do not show.
bool Filters8BitsExactly(vtkOpenGLRenderWindow* window)
{
  constexpr double MostDifference = 1.0 / (64.0 * 255.0);
  static PropertyOfDevices property;
  return property.OfCurrent([&] { return LargestNarrowDifference(window) <= MostDifference; });
}

// Weights of 12 bits err by at most 2^-13 of the difference between two voxels, too little to show;
// those of 8 bits, as most graphics cards have them, by 2^-9.
bool FiltersBetweenTexelsExactly(vtkOpenGLRenderWindow* window)
{
  constexpr double MostDifference = 1.0 / 8192.0;
  static PropertyOfDevices property;
  return property.OfCurrent([&] { return LargestWeightDifference(window) <= MostDifference; });
}

void CheckForGraphicsReset()
{
  // A function of OpenGL 4.5, whose name stands for a pointer.
  const bool isKnown = glGetGraphicsResetStatus != nullptr;
  const bool isTold = isKnown && glGetGraphicsResetStatus() != GL_NO_ERROR;
  // Somebody else may have asked before, such as Qt; a lost context then answers nothing.
  if (isTold || !glGetString(GL_VERSION))
  {
    throw GraphicsReset("The graphics card was reset while the image was drawn: start the program "
                        "again, or make a new window; if this happens again, choose a smaller "
                        "image, or another driver");
  }
}

bool IsSoftwareRasterizer()
{
  const auto* const renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer && std::string(renderer).find("llvmpipe") != std::string::npos;
}

}
