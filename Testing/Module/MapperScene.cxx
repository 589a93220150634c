#include "Module/MapperScene.h"

#include "Core/Look/HeadLightShading.h"
#include "Core/Reference/ReferenceImage.h"
#include "Frame/GrayRange.h"
#include "Frame/PropertyTransferFunction.h"
#include "Frame/VolumeGeometry.h"
#include "Module/CutRays.h"
#include "Scene/FloatCapture.h"
#include "Scene/ProceduralVolume.h"

#include <vtkCellData.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

vtkSmartPointer<vtkImageData> SmallTorso()
{
  return ProceduralVolume({ ProceduralKind::Torso, { 40, 36, 24 }, 7 });
}

vtkSmartPointer<vtkImageData> TorsoOfCells()
{
  const vtkSmartPointer<vtkImageData> torso = SmallTorso();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(41, 37, 25);
  image->SetSpacing(torso->GetSpacing());
  image->SetOrigin(torso->GetOrigin());
  image->GetCellData()->SetScalars(torso->GetPointData()->GetScalars());
  return image;
}

vtkSmartPointer<vtkActor> Ball(const double centerWorld[3], double radiusMm)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centerWorld[0], centerWorld[1], centerWorld[2]);
  sphere->SetRadius(radiusMm);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(surface);
  return actor;
}

void UseDepthPeeling(vtkRenderer* renderer)
{
  renderer->UseDepthPeelingOn();
  renderer->UseDepthPeelingForVolumesOn();
  renderer->SetOcclusionRatio(0.0);
  renderer->SetMaximumNumberOfPeels(20);
}

ImageError LargerError(
  const std::vector<float>& one, const std::vector<float>& other, const std::vector<float>& truth)
{
  const ImageError a = CompareImages(one.data(), truth.data(), truth.size() / 4);
  const ImageError b = CompareImages(other.data(), truth.data(), truth.size() / 4);
  return { std::max(a.rootMeanSquare, b.rootMeanSquare), std::max(a.percentile999, b.percentile999),
    std::max(a.largest, b.largest) };
}

MapperScene::MapperScene(vtkImageData* image, int size, vtkHeadlessRenderWindow* window)
  : image(image)
  , size(size)
  , window(window)
{
  this->window->SetSize(size, size);
  this->window->AddRenderer(this->renderer);
  this->mapper->SetInputData(image);
  this->mapper->SetErrorTolerance(0.0); // tests of the tolerance set their own
  this->mapper->ProcessorMarchingOff(); // most tests are about shaders

  // Soft tissue is a veil, bone nearly opaque: visible, invisible and homogeneous regions.
  this->colors->AddRGBPoint(-200.0, 0.8, 0.5, 0.4);
  this->colors->AddRGBPoint(150.0, 0.9, 0.3, 0.2);
  this->colors->AddRGBPoint(400.0, 1.0, 0.95, 0.85);
  this->opacities->AddPoint(-200.0, 0.0);
  this->opacities->AddPoint(0.0, 0.01);
  this->opacities->AddPoint(150.0, 0.01);
  this->opacities->AddPoint(400.0, 0.2);
  vtkVolumeProperty* property = this->volume->GetProperty();
  property->SetColor(this->colors);
  property->SetScalarOpacity(this->opacities);
  property->SetInterpolationTypeToLinear();
  this->volume->SetMapper(this->mapper);
  this->renderer->AddVolume(this->volume);

  vtkCamera* camera = this->renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.6, -1.0, 0.4);
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->renderer->ResetCamera();
  camera->Zoom(1.4);
}

MapperScene::~MapperScene()
{
  this->window->RemoveRenderer(this->renderer);
}

void MapperScene::LookDown(glm::dvec3 focusWorld, double halfMm)
{
  vtkCamera* const camera = this->renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(halfMm);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetFocalPoint(focusWorld.x, focusWorld.y, focusWorld.z);
  camera->SetPosition(focusWorld.x, focusWorld.y, 30.0);
  camera->SetClippingRange(1.0, 100.0);
}

std::vector<float> MapperScene::Draw()
{
  const auto captured = CaptureFloatImage(this->window, this->renderer);
  const auto* pixels = static_cast<const float*>(captured->GetScalarPointer());
  return std::vector<float>(pixels, pixels + 4 * this->size * this->size);
}

namespace
{

Blend BlendOf(int vtkBlendMode)
{
  switch (vtkBlendMode)
  {
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return Blend::MaximumIntensity;
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return Blend::MinimumIntensity;
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      return Blend::AverageIntensity;
    case vtkVolumeMapper::ADDITIVE_BLEND:
      return Blend::Additive;
    case vtkVolumeMapper::ISOSURFACE_BLEND:
      return Blend::Isosurface;
    default:
      return Blend::Composite;
  }
}

// The points' scalars or, if there are none, the cells'.
vtkDataArray* ScalarsOf(vtkImageData* image)
{
  vtkDataArray* const ofPoints = image->GetPointData()->GetScalars();
  return ofPoints ? ofPoints : image->GetCellData()->GetScalars();
}

// A double holds the values of every type in these tests.
std::vector<double> VoxelsOf(vtkImageData* image, int component)
{
  vtkDataArray* const scalars = ScalarsOf(image);
  std::vector<double> voxels(scalars->GetNumberOfTuples());
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    voxels[i] = scalars->GetComponent(vtkIdType(i), component);
  }
  return voxels;
}

CellCorners OneValue(double value)
{
  CellCorners corners;
  corners.fill(value);
  return corners;
}

bool IsHidden(vtkUnsignedCharArray* flags, vtkIdType index, int hidden)
{
  return flags && (flags->GetValue(index) & hidden) != 0;
}

// The voxels with those that are blanked as NaN, so that the cells around them are left out.
std::vector<double> WithoutBlanked(vtkImageData* image, std::vector<double> voxels)
{
  vtkUnsignedCharArray* const flags = image->GetPointGhostArray();
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    if (IsHidden(flags, vtkIdType(i), vtkDataSetAttributes::HIDDENPOINT))
    {
      voxels[i] = std::nan("");
    }
  }
  return voxels;
}

// The corners of a cell, which are NaN if it is blanked. Cells outside repeat those at the faces.
CellCorners CornersOfVisibleCell(
  vtkImageData* image, const ScalarGrid<double>& visible, glm::ivec3 cell)
{
  const glm::ivec3 count = visible.CellCount();
  const glm::ivec3 inside = glm::clamp(cell, glm::ivec3(0), count - 1);
  const vtkIdType index =
    inside.x + vtkIdType(count.x) * (inside.y + vtkIdType(count.y) * inside.z);
  return IsHidden(image->GetCellGhostArray(), index, vtkDataSetAttributes::HIDDENCELL)
    ? OneValue(std::nan(""))
    : CornersOfCell(visible, cell);
}

// The material of cells without a value. A blanked cell has a value, but is left out.
OpticalProperties FillOfGaps(
  vtkImageData* image, vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property)
{
  const bool isBlanked = image->GetPointGhostArray() || image->GetCellGhostArray();
  const double* const rgb = mapper->GetNanColor();
  return { { rgb[0], rgb[1], rgb[2] },
    isBlanked ? 0.0
              : -std::log1p(-mapper->GetNanOpacity()) / property->GetScalarOpacityUnitDistance() };
}

// Without interpolation a voxel is a box of one value. The reference represents it as a cell, half
// a voxel away in its grid.
struct VoxelBoxes
{
  const ScalarGrid<double>& grid;

  double Value(glm::ivec3 voxel) const
  {
    return this->grid.Voxel(glm::clamp(voxel, glm::ivec3(0), this->grid.Dimensions() - 1));
  }

  std::array<CellCorners, 3> Gradients(glm::ivec3 voxel) const
  {
    const auto along = [&](glm::ivec3 axis)
    { return OneValue(0.5 * (this->Value(voxel + axis) - this->Value(voxel - axis))); };
    return { along({ 1, 0, 0 }), along({ 0, 1, 0 }), along({ 0, 0, 1 }) };
  }
};

}

bool MapperScene::IsNearest()
{
  return this->volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
}

VolumeGeometry MapperScene::ReferenceGeometry()
{
  VolumeGeometry geometry = VolumeGeometryOf(this->image, this->volume,
    this->image->GetPointData()->GetScalars() ? VoxelPlace::Points : VoxelPlace::Cells);
  if (this->IsNearest())
  {
    const glm::dmat4 voxelFromCell = glm::translate(glm::dmat4(1.0), glm::dvec3(-0.5));
    geometry.boxGrid = { geometry.boxGrid.lower + 0.5, geometry.boxGrid.upper + 0.5 };
    geometry.worldFromGrid = geometry.worldFromGrid * voxelFromCell;
    geometry.dataFromGrid = geometry.dataFromGrid * voxelFromCell;
  }
  return geometry;
}

std::vector<float> MapperScene::Truth(double tolerance, int component)
{
  const VolumeGeometry geometry = this->ReferenceGeometry();
  const std::vector<double> voxels = VoxelsOf(this->image, component);
  const ScalarGrid<double> grid(voxels.data(), geometry.dimensions);
  const std::vector<double> visibleVoxels = WithoutBlanked(this->image, voxels);
  const ScalarGrid<double> visible(visibleVoxels.data(), geometry.dimensions);
  const VoxelBoxes boxes{ grid };
  const bool isNearest = this->IsNearest();
  vtkVolumeProperty* property = this->volume->GetProperty();

  ReferenceScene scene{ [&](glm::ivec3 cell)
    {
      return isNearest ? OneValue(VoxelBoxes{ visible }.Value(cell))
                       : CornersOfVisibleCell(this->image, visible, cell);
    },
    geometry.boxGrid, TransferFunctionOf(property, component) };
  const double* const isovalues = property->GetIsoSurfaceValues()->GetValues();
  scene.isovalues.assign(
    isovalues, isovalues + property->GetIsoSurfaceValues()->GetNumberOfContours());
  scene.blend = BlendOf(this->mapper->GetBlendMode());
  scene.gap = FillOfGaps(this->image, this->mapper, property);
  scene.averagedRange = { this->mapper->GetAverageIPScalarRange()[0],
    this->mapper->GetAverageIPScalarRange()[1] };
  scene.grayRange = GrayRangeOf({ ScalarsOf(this->image), component }, scene.averagedRange);
  scene.uncutParts = CutRays(this->mapper, geometry.worldFromGrid, geometry.dataFromGrid);
  if (property->GetShade())
  {
    const HeadLight light{ glm::dvec3(property->GetAmbient()), glm::dvec3(property->GetDiffuse()),
      glm::dvec3(property->GetSpecular()), property->GetSpecularPower() };
    scene.shade = HeadLightShading(
      light,
      [&](glm::ivec3 cell)
      { return isNearest ? boxes.Gradients(cell) : GradientsOfCell(grid, cell); },
      geometry.WorldFromGridDirection());
  }
  return this->DrawReferenceOf(scene, tolerance);
}

std::vector<float> MapperScene::DrawReferenceOf(const ReferenceScene& scene, double tolerance)
{
  const VolumeGeometry geometry = this->ReferenceGeometry();
  const ReferenceView view{ ComputePixelRays(ClipFromWorld(this->renderer) * geometry.worldFromGrid,
                              geometry.boxGrid),
    geometry.WorldFromGridDirection(), this->size, this->size };
  return DrawReference(ReferenceIntegrator(scene, tolerance), view)->rgba;
}

ImageError MapperScene::ErrorOf(const Material& material, double tolerance)
{
  return this->ErrorTo(this->TruthOf(material, tolerance));
}

std::vector<float> MapperScene::TruthOf(const Material& material, double tolerance)
{
  const VolumeGeometry geometry = this->ReferenceGeometry();
  ReferenceScene scene{ {}, geometry.boxGrid, TransferFunction({}, {}, 1.0) };
  scene.material = material;
  scene.uncutParts = CutRays(this->mapper, geometry.worldFromGrid, geometry.dataFromGrid);
  return this->DrawReferenceOf(scene, tolerance);
}

std::array<float, 4> MapperScene::MiddlePixel()
{
  const std::vector<float> marched = this->DrawByProcessor();
  const std::vector<float> drawn = this->Draw();
  const std::size_t middle = 4 * (std::size_t(this->size / 2) * this->size + this->size / 2);
  for (std::size_t i = middle; i < middle + 4; ++i)
  {
    EXPECT_NEAR(marched[i], drawn[i], 1e-3) << "the processor's and the shader's";
  }
  return { drawn[middle], drawn[middle + 1], drawn[middle + 2], drawn[middle + 3] };
}

std::vector<float> MapperScene::DrawByProcessor()
{
  this->mapper->ProcessorMarchingOn();
  const std::vector<float> drawn = this->Draw();
  this->mapper->ProcessorMarchingOff();
  return drawn;
}

ImageError MapperScene::Error()
{
  return this->ErrorTo(this->Truth());
}

ImageError MapperScene::ErrorTo(const std::vector<float>& truth)
{
  const std::vector<float> marched = this->DrawByProcessor();
  return LargerError(marched, this->Draw(), truth);
}

std::vector<std::string> MapperScene::ShaderParts()
{
  vtkNew<vtkStringArray> parts;
  this->mapper->GetShaderParts(parts);
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < parts->GetNumberOfValues(); ++i)
  {
    names.push_back(parts->GetValue(i));
  }
  return names;
}

bool MapperScene::UsesShaderPart(const std::string& part)
{
  const std::vector<std::string> parts = this->ShaderParts();
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}
