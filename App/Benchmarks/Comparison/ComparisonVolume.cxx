#include "ComparisonVolume.h"

#include "Frame/PropertyTransferFunction.h"
#include "Resources/ComponentCopy.h"
#include "Resources/VolumeTexture.h"
#include "VtkVersions.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <tbb/parallel_for.h>

#include <cstdint>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr float LargestTexel16Bits = 65535.0f;

vtkDataArray* CheckedScalars(vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("A comparison method draws volumes of one component, found " +
      std::to_string(scalars ? scalars->GetNumberOfComponents() : 0));
  }
  return scalars;
}

std::vector<std::uint16_t> SixteenBits(const std::vector<float>& texels)
{
  std::vector<std::uint16_t> rounded(texels.size());
  tbb::parallel_for(std::size_t(0), texels.size(),
    [&](std::size_t i) { rounded[i] = std::uint16_t(LargestTexel16Bits * texels[i] + 0.5f); });
  return rounded;
}

}

void FilterLinearly(vtkTextureObject* texture)
{
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
}

void ComparisonVolume::Update(vtkOpenGLRenderWindow* window, vtkImageData* newImage,
  vtkVolume* volume, const ComparedForm& newForm)
{
  this->geometry = VolumeGeometryOf(newImage, volume);
  if (this->image != newImage || this->imageTime != newImage->GetMTime() ||
    this->form.voxels != newForm.voxels)
  {
    this->Release(window);
    this->image = newImage;
    this->imageTime = newImage->GetMTime();
    this->form.voxels = newForm.voxels;
    this->ReadVoxels();
    UploadVoxels(window, this->voxels, newForm.voxels, { this->texels, this->geometry.dimensions });
    this->voxelBytes = TextureBytes(this->voxels);
    ++this->version;
  }
  vtkVolumeProperty* const property = volume->GetProperty();
  if (this->propertyTime != property->GetMTime() ||
    this->form.correctedStepMm != newForm.correctedStepMm)
  {
    this->form.correctedStepMm = newForm.correctedStepMm;
    this->propertyTime = property->GetMTime();
    this->shaded = property->GetShade() != 0;
    this->reflectance = { property->GetAmbient(), property->GetDiffuse(), property->GetSpecular(),
      property->GetSpecularPower() };
    this->UploadTable(window, volume);
    ++this->version;
  }
}

void ComparisonVolume::ReadVoxels()
{
  const ComponentCopy copy = CopyAsFloats({ CheckedScalars(this->image), 0 });
  const double* const values = copy.array->GetRange(0);
  this->smallest = values[0];
  this->range = std::max(values[1] - values[0], 1e-30);
  this->texels.resize(std::size_t(copy.array->GetNumberOfTuples()));
  const auto* const floats = static_cast<const float*>(copy.array->GetVoidPointer(0));
  tbb::parallel_for(std::size_t(0), this->texels.size(),
    [&](std::size_t i) { this->texels[i] = float((floats[i] - this->smallest) / this->range); });
}

void ComparisonVolume::UploadTable(vtkOpenGLRenderWindow* window, vtkVolume* volume)
{
  this->optical = BuildOpticalTable(
    TransferFunctionOf(volume->GetProperty()), this->smallest, this->smallest + this->range);
  std::vector<glm::vec4> entries = this->optical.entries;
  if (this->form.correctedStepMm > 0.0)
  {
    for (glm::vec4& entry : entries)
    {
      entry.a = float(-std::expm1(-double(entry.a) * this->form.correctedStepMm));
    }
  }
  this->index = IndexOf(this->optical, double(entries.size()) - 1.0, this->range, this->smallest);
  this->tableBuffer->Upload(
    &entries.front().x, 4 * entries.size(), vtkOpenGLBufferObject::TextureBuffer);
  this->table->ReleaseGraphicsResources(window);
  this->table->SetContext(window);
  this->table->CreateTextureBuffer(unsigned(entries.size()), 4, VTK_FLOAT, this->tableBuffer);
}

double ComparisonVolume::Extinction(double texel) const
{
  const std::vector<glm::vec4>& entries = this->optical.entries;
  const double last = double(entries.size() - 1);
  const double place = glm::clamp(this->index.scale * texel + this->index.bias, 0.0, last);
  const auto below = std::size_t(std::min(place, last - 1.0));
  return glm::mix(double(entries[below].a), double(entries[below + 1].a), place - double(below));
}

std::vector<std::string> ComparisonVolume::FragmentFiles(
  const std::string& main, const std::string& shadow) const
{
  return this->FilesWith(ShaderFilesOf(this->form.voxels), main, shadow);
}

std::vector<std::string> ComparisonVolume::FragmentFilesOfStack(const std::string& main) const
{
  return this->FilesWith({ "Voxels/Slices2D.glsl" }, main, NoShadow);
}

std::vector<std::string> ComparisonVolume::FilesWith(
  std::vector<std::string> files, const std::string& main, const std::string& shadow) const
{
  files.insert(files.begin(), "Parameters.glsl");
  files.emplace_back("Classify/OpticalTable.glsl");
  files.emplace_back(
    this->form.correctedStepMm > 0.0 ? "Absorb/Corrected.glsl" : "Absorb/Exponential.glsl");
  if (!this->shaded)
  {
    files.emplace_back("Look/Plain.glsl");
  }
  else if (shadow == NoShadow)
  {
    files.insert(files.end(),
      { "Gradient/CentralDifferences.glsl", "Damping/None.glsl", "Shade/HeadLight.glsl",
        "Look/Lit.glsl" });
  }
  else
  {
    files.insert(files.end(), { "Gradient/CentralDifferences.glsl", "Look/InLight.glsl" });
  }
  files.insert(files.end(), { shadow, "Sample.glsl", main });
  return files;
}

void ComparisonVolume::SetUniforms(ComparisonProgram& program, const glm::dvec4& eyeGrid) const
{
  program.Set("voxelCount", glm::vec3(this->geometry.dimensions));
  program.Set("voxelCountInverse", 1.0f / glm::vec3(this->geometry.dimensions));
  program.Set("worldFromGrid", glm::mat3(this->geometry.WorldFromGridDirection()));
  program.Set("worldFromGradient", glm::mat3(this->geometry.WorldFromGridNormal()));
  program.Set("tableScales", glm::vec4(float(this->index.scale)));
  program.Set("tableBiases", glm::vec4(float(this->index.bias)));
  program.Set("lastTableIndices", glm::vec4(float(this->optical.entries.size() - 1)));
  program.Set("diffuseLight", glm::vec3(1.0f));
  program.Set("specularLight", glm::vec3(1.0f));
  program.Set("reflectances", this->reflectance);
  program.Set("eyeGrid", glm::vec4(eyeGrid));
  program.Set("boxUpperGrid", glm::vec3(this->geometry.boxGrid.upper));
  program.Set("opticalTable", this->table);
  program.Set("volumeTexture", this->voxels);
}

const std::vector<vtkSmartPointer<vtkTextureObject>>& ComparisonVolume::Stack(
  vtkOpenGLRenderWindow* window, int axis)
{
  std::vector<vtkSmartPointer<vtkTextureObject>>& stack = this->stacks[axis];
  const glm::ivec3 size = this->geometry.dimensions;
  const int right = axis == 0 ? 1 : 0;
  const int up = axis == 2 ? 1 : 2;
  for (int slice = int(stack.size()); slice < size[axis]; ++slice)
  {
    std::vector<float> pixels;
    for (int row = 0; row < size[up]; ++row)
    {
      for (int column = 0; column < size[right]; ++column)
      {
        glm::ivec3 voxel(slice);
        voxel[right] = column;
        voxel[up] = row;
        pixels.push_back(
          this->texels[voxel.x + std::size_t(size.x) * (voxel.y + std::size_t(size.y) * voxel.z)]);
      }
    }
    std::vector<std::uint16_t> rounded = SixteenBits(pixels);
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->SetInternalFormat(GL_R16);
    texture->SetFormat(GL_RED);
    texture->SetDataType(GL_UNSIGNED_SHORT);
    texture->Create2DFromRaw(
      unsigned(size[right]), unsigned(size[up]), 1, VTK_UNSIGNED_SHORT, rounded.data());
    SetVolumeFilter(texture, false);
    stack.push_back(texture);
  }
  return stack;
}

std::size_t ComparisonVolume::Bytes() const
{
  std::size_t bytes = this->voxelBytes + sizeof(glm::vec4) * this->optical.entries.size();
  for (const auto& stack : this->stacks)
  {
    bytes += stack.empty() ? 0 : 2 * this->texels.size();
  }
  return bytes;
}

void ComparisonVolume::Release(vtkWindow* window)
{
  this->voxels->ReleaseGraphicsResources(window);
  this->table->ReleaseGraphicsResources(window);
  this->tableBuffer->ReleaseGraphicsResources();
  for (auto& stack : this->stacks)
  {
    for (const auto& slice : stack)
    {
      slice->ReleaseGraphicsResources(window);
    }
    stack.clear();
  }
  this->image = nullptr;
  this->propertyTime = 0;
}

ComparedView ComparedViewOf(vtkRenderer* renderer, const VolumeGeometry& geometry)
{
  ComparedView view;
  view.window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  renderer->GetTiledSizeAndOrigin(
    &view.sizePixels.x, &view.sizePixels.y, &view.originPixels.x, &view.originPixels.y);
  vtkCamera* const camera = renderer->GetActiveCamera();
  view.clipFromGrid = ClipFromWorld(renderer) * geometry.worldFromGrid;
  view.eyeWorld = glm::make_vec3(camera->GetPosition());
  view.directionWorld = glm::make_vec3(camera->GetDirectionOfProjection());
  const glm::dvec3 up = glm::make_vec3(camera->GetViewUp());
  view.upWorld = glm::normalize(up - glm::dot(up, view.directionWorld) * view.directionWorld);
  view.isParallel = camera->GetParallelProjection() != 0;
  const glm::dmat4 gridFromWorld = glm::inverse(geometry.worldFromGrid);
  view.eyeGrid = gridFromWorld *
    (view.isParallel ? glm::dvec4(-view.directionWorld, 0.0) : glm::dvec4(view.eyeWorld, 1.0));
  return view;
}

void ComparisonFrame::Use(const std::string& main, const std::string& shadow) const
{
  this->program.Use(this->view.window, "Grid.vert.glsl", this->volume.FragmentFiles(main, shadow));
  this->volume.SetUniforms(this->program, this->view.eyeGrid);
  const glm::dmat3 gridFromWorld = glm::inverse(this->volume.Geometry().WorldFromGridDirection());
  this->program.Set("toLightWorld", glm::vec3(this->toLightWorld));
  this->program.Set("toLightGrid", glm::vec3(gridFromWorld * this->toLightWorld));
}

}
