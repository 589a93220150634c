#include "March/Device/BoxDrawing.h"

#include "Core/Geometry/ProjectedBox.h"
#include "March/RayParametersBuilder.h"
#include "March/VolumeParametersBuilder.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkType.h"
#include "vtkVolume.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <array>

namespace varimarch
{

namespace
{

// Corner i has the upper x, y or z if bit 0, 1 or 2 of i is set. Triangles are counterclockwise
// seen from outside.
const std::array<GLubyte, 36> corners = { 0, 2, 3, 0, 3, 1, /* z low */ 4, 5, 7, 4, 7,
  6,                                              /* z high */
  0, 1, 5, 0, 5, 4, /* y low */ 2, 6, 7, 2, 7, 3, /* y high */
  0, 4, 6, 0, 6, 2, /* x low */ 1, 3, 7, 1, 7, 5 /* x high */ };

}

void VolumeBoxGeometry::Draw(vtkShaderProgram* program, const Box& boxGrid)
{
  if (!this->vertices->GetHandle() || this->uploaded.lower != boxGrid.lower ||
    this->uploaded.upper != boxGrid.upper)
  {
    std::array<float, 24> positions;
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool upper = corner >> axis & 1;
        positions[3 * corner + axis] = float(upper ? boxGrid.upper[axis] : boxGrid.lower[axis]);
      }
    }
    this->vertices->Upload(positions.data(), positions.size(), vtkOpenGLBufferObject::ArrayBuffer);
    this->triangles->Upload(
      corners.data(), corners.size(), vtkOpenGLBufferObject::ElementArrayBuffer);
    this->uploaded = boxGrid;
  }

  if (this->attributesOf != program->GetHandle())
  {
    this->attributes->ShaderProgramChanged();
    this->attributesOf = program->GetHandle();
  }
  this->attributes->Bind();
  this->vertices->Bind();
  this->attributes->AddAttributeArray(
    program, this->vertices, "vertexGrid", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
  this->triangles->Bind();
  glDrawElements(GL_TRIANGLES, GLsizei(corners.size()), GL_UNSIGNED_BYTE, nullptr);
  this->triangles->Release();
  this->vertices->Release();
  this->attributes->Release();
}

void VolumeBoxGeometry::Release()
{
  this->attributes->ReleaseGraphicsResources();
  this->attributesOf = 0;
  this->vertices->ReleaseGraphicsResources();
  this->triangles->ReleaseGraphicsResources();
}

namespace
{

// The blending of a drawing with the framebuffer.
enum class Blending
{
  OverFramebuffer,  ///< Premultiplied colours are drawn over the framebuffer.
  Overwrite,        ///< Colours replace those in the framebuffer.
  AddToFramebuffer, ///< Colours are added to those in the framebuffer.
  Multiply,         ///< Colours in the framebuffer are multiplied by those that are drawn.
  CallersState      ///< The caller's blend state is kept.
};

Blending BlendingOf(const VolumeMarch& march)
{
  const RayPass pass = march.settings.pass;
  if (march.settings.role == ShaderRole::WriteLayerDepths ||
    march.settings.role == ShaderRole::LightPlaces)
  {
    return Blending::Overwrite;
  }
  if (march.settings.role == ShaderRole::DimGeometry)
  {
    return march.plan.addsUp ? Blending::AddToFramebuffer : Blending::Multiply;
  }
  if (Peels(pass))
  {
    return Blending::CallersState;
  }
  if (pass == RayPass::Block || Picks(pass))
  {
    return Blending::Overwrite;
  }
  return march.plan.addsUp ? Blending::AddToFramebuffer : Blending::OverFramebuffer;
}

// Scope guard for the OpenGL state in which a box is drawn.
class BoxDrawingState
{
public:
  BoxDrawingState(vtkOpenGLState* state, bool mirrored, Blending blending)
    : depthTest(state, GL_DEPTH_TEST)
    , blend(state, GL_BLEND)
    , cullFace(state, GL_CULL_FACE)
    , depthMask(state)
    , blendFunction(state)
    , state(state)
    , depthClamp(glIsEnabled(GL_DEPTH_CLAMP))
  {
    state->vtkglGetIntegerv(GL_CULL_FACE_MODE, &this->cullFaceMode);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    if (blending == Blending::Multiply)
    {
      state->SetEnumState(GL_BLEND, true);
      state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    }
    else if (blending != Blending::CallersState)
    {
      const GLenum factor =
        blending == Blending::AddToFramebuffer ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA;
      state->SetEnumState(GL_BLEND, blending != Blending::Overwrite);
      state->vtkglBlendFuncSeparate(GL_ONE, factor, GL_ONE, factor);
    }
    // Inner faces are drawn, because every pixel has one even if the camera is inside the box.
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(mirrored ? GL_BACK : GL_FRONT);
    // The box only selects pixels, so the far plane must not cut it.
    glEnable(GL_DEPTH_CLAMP);
  }

  ~BoxDrawingState()
  {
    if (!this->depthClamp)
    {
      glDisable(GL_DEPTH_CLAMP);
    }
    this->state->vtkglCullFace(GLenum(this->cullFaceMode));
  }

private:
  vtkOpenGLState::ScopedglEnableDisable depthTest;
  vtkOpenGLState::ScopedglEnableDisable blend;
  vtkOpenGLState::ScopedglEnableDisable cullFace;
  vtkOpenGLState::ScopedglDepthMask depthMask;
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction;
  vtkOpenGLState* state;
  GLboolean depthClamp;
  GLint cullFaceMode = GL_BACK;
};

VolumeTextures TexturesOf(
  const VolumeMarch& march, const VolumeResources& volume, const VolumeBlock* block)
{
  const VolumeTextures textures = volume.Textures(march.settings, block);
  const int filter = march.settings.nearest ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
  for (vtkTextureObject* const voxels :
    { textures.volumeTexture.onDevice, textures.gradientTexture.onDevice })
  {
    if (voxels)
    {
      voxels->SetMinificationFilter(filter);
      voxels->SetMagnificationFilter(filter);
    }
  }
  return textures;
}

}

DrawnBlock AllThatIsVisible(const Box& drawnBox)
{
  constexpr double Nowhere = 1e30; // a plane that no ray reaches
  return { nullptr, {}, drawnBox, drawnBox, glm::dvec3(Nowhere) };
}

Box WithItsEdges(const Box& box)
{
  const glm::dvec3 more = glm::max(0.125 * (box.upper - box.lower), glm::dvec3(1.0));
  return { box.lower - more, box.upper + more };
}

// The box around everything between near and far plane.
Box CoverOfView(const Frame& frame)
{
  const glm::dmat4 gridFromClip = glm::inverse(frame.ClipFromGrid());
  Box box = frame.geometry.boxGrid;
  for (const glm::dvec4& corner : CornersOf({ glm::dvec3(-1.0), glm::dvec3(1.0) }, gridFromClip))
  {
    const glm::dvec3 place = glm::dvec3(corner) / corner.w;
    box = { glm::min(box.lower, place), glm::max(box.upper, place) };
  }
  return WithItsEdges(box);
}

Box CoverOfRays(const Frame& frame, const MarchPlan& plan, const Box& box)
{
  if (plan.isTrial)
  {
    return CoverOfView(frame);
  }
  return plan.addsUp ? WithItsEdges(box) : box;
}

void BoxDrawing::Draw(const Frame& frame, const MarchPlan& plan, const DrawnBlock& drawn,
  const EarlierDrawings& earlier)
{
  const VolumeMarch march = MarchOf(frame, plan);
  this->UpdateProgram(march);
  this->SetParameters(march, drawn, earlier);
  {
    const bool mirrored = glm::determinant(frame.geometry.WorldFromGridDirection()) < 0.0;
    const BoxDrawingState drawing(frame.view.window->GetState(), mirrored, BlendingOf(march));
    this->boxGeometry.Draw(this->program.Program(), drawn.coverGrid);
  }
  this->program.DeactivateTextures();
}

void BoxDrawing::UpdateProgram(const VolumeMarch& march)
{
  if (this->program.Use(march.frame.view.window, march.settings, march.frame.userCode))
  {
    ++this->shaderBuilds;
  }
  if (Marches(march.settings))
  {
    this->shaderParts = this->program.Parts();
  }
  else if (march.settings.role == ShaderRole::ShowMarchedImage)
  {
    this->shaderParts.clear();
  }
}

RayTextures BoxDrawing::TexturesOfRays(const EarlierDrawings& earlier)
{
  RayTextures textures = this->resources.Textures();
  textures.gatheredTexture.onDevice = earlier.gathered;
  textures.coarseTexture.onDevice = earlier.coarse;
  textures.sumTexture.onDevice = earlier.sum;
  textures.marchedTexture.onDevice = earlier.marched;
  return textures;
}

RayParameters BoxDrawing::ParametersOfRays(
  const VolumeMarch& march, const DrawnBlock& drawn, const EarlierDrawings& earlier)
{
  const Viewport& viewport = march.plan.viewport;
  RayParameters rays = RayParametersOf(march, this->resources.DrawnBox());
  rays.boxLowerGrid = drawn.boxGrid.lower;
  rays.boxUpperGrid = drawn.boxGrid.upper;
  rays.sharedUpperGrid = drawn.sharedUpperGrid;
  rays.depthPixelsPerPixel =
    glm::dvec2(this->resources.Depth().SizePixels()) / glm::dvec2(march.plan.ImagePixels());
  rays.imageCount = float(earlier.imageCount);
  rays.rowsOfNext = earlier.rowsOfNext;
  if (earlier.marched)
  {
    const Viewport& pixels = earlier.marchedPixels;
    rays.marchedColumns = pixels.width;
    rays.marchedPixels = pixels.width * pixels.height;
    rays.viewportOriginPixels =
      glm::dvec2(viewport.left + pixels.left, viewport.bottom + pixels.bottom);
  }
  return rays;
}

// In the shader, the other volumes come before the first, in whose grid the rays are marched.
void BoxDrawing::SetVolumes(const VolumeMarch& march, const DrawnBlock& drawn)
{
  const Frame& frame = march.frame;
  const std::size_t count = frame.others.size() + 1;
  for (std::size_t i = 0; drawn.block && i < frame.others.size(); ++i)
  {
    const VolumeMarch other = MarchOfOther(frame, march.plan, i);
    VolumeResources& volume = this->resources.Other(i);
    const VolumeBlock& block = volume.Blocks().Take(frame.view.window, 0);
    const VoxelRegion voxels{ glm::ivec3(0), other.frame.geometry.dimensions };
    VolumeParameters parameters =
      VolumeParametersOf(other, volume, VolumeOfShaders(other, volume, &block, voxels));
    parameters.ownGridFromRays = GridFromGrid(other.frame.geometry, frame.geometry);
    this->program.SetVolume(i, count, parameters, TexturesOf(other, volume, &block));
  }
  const VolumeResources& volume = this->resources.First();
  this->program.SetVolume(count - 1, count,
    VolumeParametersOf(march, volume, VolumeOfShaders(march, volume, drawn.block, drawn.voxels)),
    TexturesOf(march, volume, drawn.block));
}

void BoxDrawing::SetParameters(
  const VolumeMarch& march, const DrawnBlock& drawn, const EarlierDrawings& earlier)
{
  const bool marchesRays =
    march.settings.role == ShaderRole::MarchRays || march.settings.role == ShaderRole::LightPlaces;
  vtkVolume* const prop = march.frame.view.prop;
  this->program.SetRays(
    this->ParametersOfRays(march, drawn, earlier), this->TexturesOfRays(earlier));
  this->program.SetRayPixels(march.plan);
  if (marchesRays && march.settings.pass != RayPass::Accumulated)
  {
    this->SetVolumes(march, drawn);
  }
  if (Peels(march.settings.pass))
  {
    march.frame.pass.renderPass->SetShaderParameters(
      this->program.Program(), nullptr, prop, nullptr);
  }
  if (marchesRays && Marches(march.settings))
  {
    this->program.SetUniformsOf(prop);
  }
}

void BoxDrawing::Release()
{
  this->boxGeometry.Release();
  this->program.Release();
}

}
