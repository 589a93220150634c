#include "Stages/VolumeStage.h"

#include "Core/Look/HeadLightShading.h"
#include "Core/Reference/ReferenceIntegrator.h"
#include "Frame/FiniteRange.h"
#include "Frame/PropertyTransferFunction.h"
#include "Scene/Images/FloatCapture.h"
#include "Scene/Model/Scene.h"
#include "Stages/CutRays.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace varimarch
{

namespace
{

void CopyOfEveryMapper(vtkVariationFieldVolumeMapper* from, vtkVolumeMapper* to)
{
  to->SetInputDataObject(from->GetInputDataObject(0, 0));
  to->SetScalarMode(from->GetScalarMode());
  to->SetBlendMode(from->GetBlendMode());
  to->SetAverageIPScalarRange(from->GetAverageIPScalarRange());
  to->SetCropping(from->GetCropping());
  to->SetCroppingRegionPlanes(from->GetCroppingRegionPlanes());
  to->SetCroppingRegionFlags(from->GetCroppingRegionFlags());
  to->SetClippingPlanes(from->GetClippingPlanes());
}

// Give VTK's own mappers the input and the settings of ours that they have too.
void CopySettings(vtkVariationFieldVolumeMapper* from, vtkGPUVolumeRayCastMapper* to)
{
  CopyOfEveryMapper(from, to);
  to->SetMaskInput(from->GetMaskInput());
  to->SetMaskType(from->GetMaskType());
  to->SetMaskBlendFactor(from->GetMaskBlendFactor());
  to->SetAutoAdjustSampleDistances(from->GetAutoAdjustSampleDistances());
  to->SetLockSampleDistanceToInputSpacing(from->GetLockSampleDistanceToInputSpacing());
  to->SetSampleDistance(float(from->GetSampleDistance()));
  to->SetImageSampleDistance(from->GetImageSampleDistance());
  to->SetUseJittering(from->GetUseJittering());
  to->SetFinalColorWindow(from->GetFinalColorWindow());
  to->SetFinalColorLevel(from->GetFinalColorLevel());
  to->SetRenderToImage(from->GetRenderToImage());
}

void CopySettings(vtkVariationFieldVolumeMapper* from, vtkFixedPointVolumeRayCastMapper* to)
{
  CopyOfEveryMapper(from, to);
  // By default this mapper adapts its rays to a frame rate, and samples every millimetre.
  to->AutoAdjustSampleDistancesOff();
  to->SetLockSampleDistanceToInputSpacing(from->GetAutoAdjustSampleDistances());
  to->SetSampleDistance(float(from->GetSampleDistance()));
}

}

VolumeStage::VolumeStage(vtkImageData* image, int size, vtkHeadlessRenderWindow* window)
  : image(image)
  , size(size)
  , window(window)
{
  this->window->SetSize(size, size);
  this->window->AddRenderer(this->renderer);
  this->mapper->SetInputData(image);
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

VolumeStage::~VolumeStage()
{
  this->window->RemoveRenderer(this->renderer);
}

std::vector<float> VolumeStage::Draw()
{
  const auto captured = CaptureFloatImage(this->window, this->renderer);
  const auto* pixels = static_cast<const float*>(captured->GetScalarPointer());
  return std::vector<float>(pixels, pixels + 4 * this->size * this->size);
}

void VolumeStage::UseMapper(MapperKind kind)
{
  this->mapper->SetProcessorMarching(kind == MapperKind::Varimarch);
  vtkSmartPointer<vtkVolumeMapper> drawing = this->mapper.Get();
  if (kind == MapperKind::VtkGpu)
  {
    const auto gpu = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
    CopySettings(this->mapper, gpu);
    drawing = gpu;
  }
  if (kind == MapperKind::VtkCpu)
  {
    const auto cpu = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
    CopySettings(this->mapper, cpu);
    drawing = cpu;
  }
  this->volume->SetMapper(drawing);
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

// A double holds the values of every type but large 64 bit integers.
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

bool VolumeStage::IsNearest()
{
  return this->volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
}

VolumeGeometry VolumeStage::ReferenceGeometry()
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

std::vector<float> VolumeStage::Truth(double tolerance, int component)
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

std::vector<float> VolumeStage::DrawReferenceOf(const ReferenceScene& scene, double tolerance)
{
  const VolumeGeometry geometry = this->ReferenceGeometry();
  const ReferenceView view{ ComputePixelRays(ClipFromWorld(this->renderer) * geometry.worldFromGrid,
                              geometry.boxGrid),
    geometry.WorldFromGridDirection(), this->size, this->size };
  return DrawReference(ReferenceIntegrator(scene, tolerance), view)->rgba;
}

std::vector<float> VolumeStage::TruthOf(const Material& material, double tolerance)
{
  const VolumeGeometry geometry = this->ReferenceGeometry();
  ReferenceScene scene{ {}, geometry.boxGrid, TransferFunction({}, {}, 1.0) };
  scene.material = material;
  scene.uncutParts = CutRays(this->mapper, geometry.worldFromGrid, geometry.dataFromGrid);
  return this->DrawReferenceOf(scene, tolerance);
}

}
