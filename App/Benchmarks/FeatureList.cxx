#include "FeatureList.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMultiVolume.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkUniformGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolumeCollection.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

// Conversions of a volume to other forms, whose costs are measured. The input has one component per
// point.

vtkDataArray* ScalarsOf(vtkImageData* image)
{
  return image->GetPointData()->GetScalars();
}

vtkSmartPointer<vtkImageData> SameGrid(vtkImageData* image)
{
  const auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->CopyStructure(image);
  return copy;
}

// Calls a function for each point of a ball about the centre, whose radius is a quarter of the
// volume's side.
template <class OnPoint>
void ForPointsInBall(vtkImageData* image, const OnPoint& onPoint)
{
  const int* size = image->GetDimensions();
  vtkIdType point = 0;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x, ++point)
      {
        const double offset = std::hypot(
          double(x) / size[0] - 0.5, double(y) / size[1] - 0.5, double(z) / size[2] - 0.5);
        if (offset < 0.25)
        {
          onPoint(point);
        }
      }
    }
  }
}

// The volume with two components, both with the input's scalars.
vtkSmartPointer<vtkImageData> WithTwoComponents(vtkImageData* image)
{
  vtkDataArray* scalars = ScalarsOf(image);
  const auto pairs = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(scalars->GetNumberOfTuples());
  pairs->CopyComponent(0, scalars, 0);
  pairs->CopyComponent(1, scalars, 0);
  const auto copy = SameGrid(image);
  copy->GetPointData()->SetScalars(pairs);
  return copy;
}

// The volume with four byte components for red, green, blue and opacity, all with the input's
// scalars.
vtkSmartPointer<vtkImageData> WithFourColors(vtkImageData* image)
{
  vtkDataArray* scalars = ScalarsOf(image);
  const double* range = scalars->GetRange();
  const double bytesPerScalar = 255.0 / std::max(range[1] - range[0], 1e-30);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("colors");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const auto byte =
      static_cast<unsigned char>((scalars->GetComponent(i, 0) - range[0]) * bytesPerScalar);
    const unsigned char color[4] = { byte, byte, byte, byte };
    colors->SetTypedTuple(i, color);
  }
  const auto copy = SameGrid(image);
  copy->GetPointData()->SetScalars(colors);
  return copy;
}

// The volume as cell data, with one cell fewer than points on each axis.
vtkSmartPointer<vtkDataSet> OnCells(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    ++extent[2 * axis + 1];
  }
  const auto copy = SameGrid(image);
  copy->SetExtent(extent);
  copy->GetCellData()->SetScalars(ScalarsOf(image));
  return copy;
}

// The volume on a rectilinear grid with the same coordinates.
vtkSmartPointer<vtkDataSet> OnRectilinearGrid(vtkImageData* image)
{
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetExtent(image->GetExtent());
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = image->GetExtent()[2 * axis];
    for (int i = 0; i < image->GetDimensions()[axis]; ++i)
    {
      coordinates[axis]->InsertNextValue(
        image->GetOrigin()[axis] + (first + i) * image->GetSpacing()[axis]);
    }
  }
  grid->SetXCoordinates(coordinates[0]);
  grid->SetYCoordinates(coordinates[1]);
  grid->SetZCoordinates(coordinates[2]);
  grid->GetPointData()->SetScalars(ScalarsOf(image));
  return grid;
}

// The volume with the points of a ball about the centre blanked.
vtkSmartPointer<vtkDataSet> WithBlankedBall(vtkImageData* image)
{
  const auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->CopyStructure(image);
  grid->GetPointData()->SetScalars(ScalarsOf(image));
  ForPointsInBall(image, [&](vtkIdType point) { grid->BlankPoint(point); });
  return grid;
}

// A mask that is 255 in a ball about the centre and 0 elsewhere, for use as a binary mask and as a
// label map with one label.
vtkSmartPointer<vtkImageData> BallMask(vtkImageData* image)
{
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetName("labels");
  labels->SetNumberOfTuples(image->GetNumberOfPoints());
  labels->Fill(0.0);
  ForPointsInBall(image, [&](vtkIdType point) { labels->SetValue(point, 255); });
  const auto mask = SameGrid(image);
  mask->GetPointData()->SetScalars(labels);
  return mask;
}

// A transfer function of scalar and gradient magnitude: opacity grows with both.
vtkSmartPointer<vtkImageData> OpacityOfScalarAndGradient()
{
  constexpr int Side = 256;
  const auto table = vtkSmartPointer<vtkImageData>::New();
  table->SetDimensions(Side, Side, 1);
  table->AllocateScalars(VTK_FLOAT, 4);
  for (int gradient = 0; gradient < Side; ++gradient)
  {
    for (int scalar = 0; scalar < Side; ++scalar)
    {
      auto* entry = static_cast<float*>(table->GetScalarPointer(scalar, gradient, 0));
      const float part = float(scalar) / float(Side - 1);
      entry[0] = 1.0f;
      entry[1] = part;
      entry[2] = 0.5f * part;
      entry[3] = part < 0.3f ? 0.0f : 0.2f * part * float(gradient + 16) / float(Side + 15);
    }
  }
  return table;
}

// Switches for features that only our mapper has. With another mapper they do nothing.

void WithOurs(
  const FeatureStage& stage, const std::function<void(vtkVariationFieldVolumeMapper*)>& set)
{
  auto* adapter = vtkVariationFieldGPUVolumeRayCastMapper::SafeDownCast(stage.mapper);
  if (adapter)
  {
    set(adapter->GetVariationFieldMapper());
  }
}

void CubicOn(const FeatureStage& stage)
{
  WithOurs(stage, [](vtkVariationFieldVolumeMapper* mapper) { mapper->CubicInterpolationOn(); });
}

void CubicOff(const FeatureStage& stage)
{
  WithOurs(stage, [](vtkVariationFieldVolumeMapper* mapper) { mapper->CubicInterpolationOff(); });
}

// Damps by a fortieth of the steepest slope that two neighbouring voxels can have.
void DampingOn(const FeatureStage& stage)
{
  const double* range = stage.image->GetScalarRange();
  const double gradient = (range[1] - range[0]) / stage.image->GetSpacing()[0] / 40.0;
  WithOurs(stage,
    [gradient](vtkVariationFieldVolumeMapper* mapper) { mapper->SetDampingGradient(gradient); });
}

void DampingOff(const FeatureStage& stage)
{
  WithOurs(stage, [](vtkVariationFieldVolumeMapper* mapper) { mapper->SetDampingGradient(0.0); });
}

using Stage = const FeatureStage&;

vtkVolumeProperty* PropertyOf(Stage stage)
{
  return stage.volume->GetProperty();
}

// The scalar at a fraction of the value range.
double ScalarAt(Stage stage, double part)
{
  const double* range = stage.image->GetScalarRange();
  return range[0] + part * (range[1] - range[0]);
}

// Half the steepest slope that two neighbouring voxels can have.
double HalfSteepestGradient(Stage stage)
{
  const double* range = stage.image->GetScalarRange();
  return 0.5 * (range[1] - range[0]) / stage.image->GetSpacing()[0];
}

void ShadeOff(Stage stage)
{
  PropertyOf(stage)->ShadeOff();
}

void ShadeOn(Stage stage)
{
  PropertyOf(stage)->ShadeOn();
}

void CompositeOn(Stage stage)
{
  stage.mapper->SetBlendModeToComposite();
}

Feature::Switch BlendMode(int mode)
{
  return [mode](Stage stage) { stage.mapper->SetBlendMode(mode); };
}

void IsosurfaceOn(Stage stage)
{
  PropertyOf(stage)->GetIsoSurfaceValues()->SetValue(0, ScalarAt(stage, 0.4));
  stage.mapper->SetBlendModeToIsoSurface();
}

void SliceAcross(Stage stage)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(stage.volume->GetCenter());
  plane->SetNormal(0.3, -1.0, 0.2);
  PropertyOf(stage)->SetSliceFunction(plane);
  stage.mapper->SetBlendModeToSlice();
}

void GradientOpacityOn(Stage stage)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.2);
  opacity->AddPoint(0.25 * HalfSteepestGradient(stage), 1.0);
  PropertyOf(stage)->SetGradientOpacity(opacity);
}

void GradientOpacityOff(Stage stage)
{
  PropertyOf(stage)->SetGradientOpacity(nullptr);
}

// Adds three lights that are fixed in the scene to the head light.
void LightsOn(Stage stage)
{
  const double* center = stage.volume->GetCenter();
  const double reach = stage.volume->GetLength();
  const std::array<std::array<double, 3>, 3> directions = { { { 1.0, -1.0, 0.5 },
    { -1.0, -0.5, 0.0 }, { 0.0, -0.5, 1.0 } } };
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPositional(i == 0);
    light->SetFocalPoint(center);
    light->SetPosition(center[0] + reach * directions[i][0], center[1] + reach * directions[i][1],
      center[2] + reach * directions[i][2]);
    light->SetIntensity(0.4);
    stage.renderer->AddLight(light);
  }
}

void LightsOff(Stage stage)
{
  stage.renderer->RemoveAllLights();
  stage.renderer->CreateLight();
}

void NearestOn(Stage stage)
{
  PropertyOf(stage)->SetInterpolationTypeToNearest();
}

void NearestOff(Stage stage)
{
  PropertyOf(stage)->SetInterpolationTypeToLinear();
}

void CroppingOff(Stage stage)
{
  stage.mapper->CroppingOff();
}

Feature::Switch Cropping(int flags)
{
  return [flags](Stage stage)
  {
    const double* bounds = stage.image->GetBounds();
    std::array<double, 6> planes = {};
    for (int side = 0; side < 6; ++side)
    {
      const double* axis = bounds + side / 2 * 2;
      planes[side] = axis[0] + (side % 2 == 0 ? 0.25 : 0.75) * (axis[1] - axis[0]);
    }
    stage.mapper->SetCroppingRegionPlanes(planes.data());
    stage.mapper->SetCroppingRegionFlags(flags);
    stage.mapper->CroppingOn();
  };
}

void ClippingOn(Stage stage)
{
  for (const std::array<double, 3>& normal :
    { std::array<double, 3>{ 1.0, 0.3, 0.0 }, std::array<double, 3>{ 0.0, 1.0, 0.4 } })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(stage.volume->GetCenter());
    plane->SetNormal(normal.data());
    stage.mapper->AddClippingPlane(plane);
  }
}

void ClippingOff(Stage stage)
{
  stage.mapper->RemoveAllClippingPlanes();
}

Feature::Switch Sphere(double opacity)
{
  return [opacity](Stage stage)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(stage.volume->GetCenter());
    sphere->SetRadius(0.15 * stage.volume->GetLength());
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(opacity);
    stage.renderer->AddActor(actor);
  };
}

void SphereOff(Stage stage)
{
  stage.renderer->RemoveActor(stage.renderer->GetActors()->GetLastActor());
}

void TranslucentSphereOn(Stage stage)
{
  stage.renderer->UseDepthPeelingOn();
  stage.renderer->UseDepthPeelingForVolumesOn();
  Sphere(0.5)(stage);
}

void TranslucentSphereOff(Stage stage)
{
  stage.renderer->UseDepthPeelingOff();
  stage.renderer->UseDepthPeelingForVolumesOff();
  SphereOff(stage);
}

void WindowOn(Stage stage)
{
  stage.mapper->SetFinalColorWindow(0.8f);
  stage.mapper->SetFinalColorLevel(0.45f);
}

void WindowOff(Stage stage)
{
  stage.mapper->SetFinalColorWindow(1.0f);
  stage.mapper->SetFinalColorLevel(0.5f);
}

void ToImages(Stage stage)
{
  stage.mapper->RenderToImageOn();
}

void ToWindow(Stage stage)
{
  stage.mapper->RenderToImageOff();
}

Feature::Switch Input(vtkSmartPointer<vtkDataSet> (*make)(vtkImageData*))
{
  return [make](Stage stage) { stage.mapper->SetInputDataObject(make(stage.image)); };
}

void PlainInput(Stage stage)
{
  stage.mapper->SetInputDataObject(stage.image);
  PropertyOf(stage)->IndependentComponentsOn();
}

void DependentInput(Stage stage)
{
  stage.mapper->SetInputDataObject(WithFourColors(stage.image));
  PropertyOf(stage)->IndependentComponentsOff();
}

void IndependentInput(Stage stage)
{
  stage.mapper->SetInputDataObject(WithTwoComponents(stage.image));
  vtkVolumeProperty* property = PropertyOf(stage);
  property->SetColor(1, property->GetRGBTransferFunction(0));
  property->SetScalarOpacity(1, property->GetScalarOpacity(0));
  property->SetScalarOpacityUnitDistance(1, property->GetScalarOpacityUnitDistance(0));
}

void TwoValuesOn(Stage stage)
{
  PropertyOf(stage)->SetTransferFunction2D(OpacityOfScalarAndGradient());
  PropertyOf(stage)->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
}

void TwoValuesOff(Stage stage)
{
  PropertyOf(stage)->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
}

void BinaryMaskOn(Stage stage)
{
  stage.mapper->SetMaskInput(BallMask(stage.image));
  stage.mapper->SetMaskTypeToBinary();
}

void LabelMapOn(Stage stage)
{
  constexpr int Label = 255;
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(ScalarAt(stage, 0.0), 0.2, 0.3, 1.0);
  color->AddRGBPoint(ScalarAt(stage, 1.0), 0.8, 1.0, 1.0);
  PropertyOf(stage)->SetLabelColor(Label, color);
  PropertyOf(stage)->SetLabelScalarOpacity(Label, PropertyOf(stage)->GetScalarOpacity());
  stage.mapper->SetMaskInput(BallMask(stage.image));
  stage.mapper->SetMaskTypeToLabelMap();
}

void MaskOff(Stage stage)
{
  stage.mapper->SetMaskInput(nullptr);
}

// Adds the same volume again, rotated.
void SecondVolumeOn(Stage stage)
{
  vtkNew<vtkVolume> second;
  second->SetProperty(PropertyOf(stage));
  second->SetUserTransform(stage.volume->GetUserTransform());
  second->SetOrigin(stage.volume->GetCenter());
  second->RotateZ(40.0);
  vtkNew<vtkMultiVolume> several;
  several->SetMapper(stage.mapper);
  several->SetVolume(stage.volume, 0);
  several->SetVolume(second, 1);
  stage.mapper->SetInputDataObject(1, stage.image);
  stage.renderer->RemoveVolume(stage.volume);
  stage.renderer->AddVolume(several);
}

void SecondVolumeOff(Stage stage)
{
  stage.mapper->RemoveInputConnection(1, 0);
  vtkVolumeCollection* const volumes = stage.renderer->GetVolumes();
  stage.renderer->RemoveVolume(vtkVolume::SafeDownCast(volumes->GetItemAsObject(0)));
  stage.renderer->AddVolume(stage.volume);
}

}

const std::vector<Feature>& Features()
{
  using Mapper = vtkGPUVolumeRayCastMapper;
  static const std::vector<Feature> features = {
    { "shading", "composite", ShadeOff, ShadeOn, ShadeOff },
    { "lights", "shading", ShadeOn, LightsOn, LightsOff },
    { "gradient-opacity", "composite", ShadeOff, GradientOpacityOn, GradientOpacityOff },
    { "gradient-opacity-shaded", "shading", ShadeOn, GradientOpacityOn, GradientOpacityOff },
    { "two-values", "composite", ShadeOff, TwoValuesOn, TwoValuesOff },
    { "nearest", "composite", ShadeOff, NearestOn, NearestOff },
    { "damping", "shading", ShadeOn, DampingOn, DampingOff, false },
    { "cubic", "composite", ShadeOff, CubicOn, CubicOff, false },
    { "cubic-shaded", "shading", ShadeOn, CubicOn, CubicOff, false },
    { "maximum", "composite", ShadeOff, BlendMode(Mapper::MAXIMUM_INTENSITY_BLEND), CompositeOn },
    { "minimum", "composite", ShadeOff, BlendMode(Mapper::MINIMUM_INTENSITY_BLEND), CompositeOn },
    { "average", "composite", ShadeOff, BlendMode(Mapper::AVERAGE_INTENSITY_BLEND), CompositeOn },
    { "additive", "composite", ShadeOff, BlendMode(Mapper::ADDITIVE_BLEND), CompositeOn },
    { "isosurface", "shading", ShadeOn, IsosurfaceOn, CompositeOn },
    { "slice", "composite", ShadeOff, SliceAcross, CompositeOn },
    { "cropping-box", "composite", ShadeOff, Cropping(VTK_CROP_SUBVOLUME), CroppingOff },
    { "cropping-fence", "composite", ShadeOff, Cropping(VTK_CROP_FENCE), CroppingOff },
    { "clipping", "composite", ShadeOff, ClippingOn, ClippingOff },
    { "opaque-geometry", "composite", ShadeOff, Sphere(1.0), SphereOff },
    { "translucent-geometry", "composite", ShadeOff, TranslucentSphereOn, TranslucentSphereOff },
    { "jitter", "composite", ShadeOff, [](Stage stage) { stage.mapper->UseJitteringOn(); },
      [](Stage stage) { stage.mapper->UseJitteringOff(); } },
    { "image-distance-2", "composite", ShadeOff,
      [](Stage stage) { stage.mapper->SetImageSampleDistance(2.0f); },
      [](Stage stage) { stage.mapper->SetImageSampleDistance(1.0f); } },
    { "window-level", "composite", ShadeOff, WindowOn, WindowOff },
    { "mask-binary", "composite", ShadeOff, BinaryMaskOn, MaskOff },
    { "mask-labels", "composite", ShadeOff, LabelMapOn, MaskOff },
    { "independent-2", "composite", ShadeOff, IndependentInput, PlainInput },
    { "dependent-4", "composite", ShadeOff, DependentInput, PlainInput },
    { "cell-data", "composite", ShadeOff, Input(OnCells), PlainInput },
    { "rectilinear", "composite", ShadeOff, Input(OnRectilinearGrid), PlainInput },
    { "blanking", "composite", ShadeOff, Input(WithBlankedBall), PlainInput },
    { "multi-volume", "composite", ShadeOff, SecondVolumeOn, SecondVolumeOff },
    { "picture-and-depth", "composite", ShadeOff, ToImages, ToWindow },
  };
  return features;
}

std::vector<std::string> FeatureNames()
{
  std::vector<std::string> names;
  for (const Feature& feature : Features())
  {
    names.push_back(feature.name);
  }
  return names;
}

}
