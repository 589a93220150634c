// Rays that packets march in pieces: in masks, by labels, in cropping regions, between translucent
// geometry. Images match those of the shaders to a twentieth of a grey level (RMSE).

#include "Module/Scenes/ProcessorMarching.h"
#include "Resources/ComponentCopy.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <limits>

using namespace varimarch;

namespace
{

using Mapper = vtkVariationFieldVolumeMapper;

// Three glass balls, which have six layers, and an opaque one, around the centre.
void PutGlassIn(MapperScene& scene)
{
  UseDepthPeeling(scene.renderer);
  for (const double part : { 0.05, 0.1, 0.15, 0.2 })
  {
    const double length = scene.image->GetLength();
    const double center[3] = { (part - 0.15) * length, 0.02 * length, 0.0 };
    const vtkSmartPointer<vtkActor> ball = Ball(center, part * length);
    ball->GetProperty()->SetColor(0.2, 0.5 + part, 1.0 - 3.0 * part);
    ball->GetProperty()->SetOpacity(part == 0.05 ? 1.0 : 0.3);
    scene.renderer->AddActor(ball);
  }
}

// Crops to regions at the edges, so that those behind are visible.
void Crop(MapperScene& scene)
{
  double planes[6];
  scene.image->GetBounds(planes);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double thirdMm = (planes[2 * axis + 1] - planes[2 * axis]) / 3.0;
    planes[2 * axis] += thirdMm;
    planes[2 * axis + 1] -= 0.8 * thirdMm;
  }
  scene.mapper->CroppingOn();
  scene.mapper->SetCroppingRegionPlanes(planes);
  scene.mapper->SetCroppingRegionFlagsToFence();
}

// Three kinds of voxels in slabs that cross the view.
void UseMask(MapperScene& scene, bool isBinary)
{
  vtkNew<vtkImageData> mask;
  mask->SetDimensions(scene.image->GetDimensions());
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int z = 0; z < mask->GetDimensions()[2]; ++z)
  {
    for (int y = 0; y < mask->GetDimensions()[1]; ++y)
    {
      for (int x = 0; x < mask->GetDimensions()[0]; ++x)
      {
        mask->SetScalarComponentFromDouble(x, y, z, 0, (x / 13 + y / 5 + z / 9) % 3);
      }
    }
  }
  scene.mapper->SetMaskInput(mask);
  scene.mapper->SetMaskType(isBinary ? 0 : 1);
}

// The second kind is green, the third has its own veil.
void UseLabels(MapperScene& scene)
{
  vtkNew<vtkColorTransferFunction> green;
  green->AddRGBPoint(0.0, 0.1, 0.9, 0.2);
  vtkNew<vtkPiecewiseFunction> veil;
  veil->AddPoint(-100.0, 0.0);
  veil->AddPoint(300.0, 0.08);
  scene.volume->GetProperty()->SetLabelColor(1, green);
  scene.volume->GetProperty()->SetLabelScalarOpacity(2, veil);
  UseMask(scene, false);
}

// Balls of NaN values, beside each other and at a face of the volume.
void MakeGaps(MapperScene& scene, int type)
{
  const vtkSmartPointer<vtkImageData> image = TorsoOfType(type);
  const glm::dvec3 size(
    image->GetDimensions()[0], image->GetDimensions()[1], image->GetDimensions()[2]);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const vtkIdType row = i / vtkIdType(size.x);
    const glm::dvec3 voxel(i % vtkIdType(size.x), row % vtkIdType(size.y), row / vtkIdType(size.y));
    const glm::dvec3 place = voxel / size - 0.5;
    const bool isIn = glm::length(place) < 0.1 ||
      glm::length(place - glm::dvec3(0.2, 0.1, 0.0)) < 0.15 ||
      glm::length(place - glm::dvec3(0.0, -0.5, 0.1)) < 0.2;
    if (isIn)
    {
      image->GetPointData()->GetScalars()->SetComponent(
        i, 0, std::numeric_limits<double>::quiet_NaN());
    }
  }
  scene.mapper->SetInputData(image);
}

// Blanks every other slab of cells.
void BlankCells(MapperScene& scene)
{
  vtkNew<vtkImageData> image;
  image->DeepCopy(scene.image);
  vtkUnsignedCharArray* const flags = image->AllocateCellGhostArray();
  const int* const size = image->GetDimensions();
  for (vtkIdType i = 0; i < flags->GetNumberOfTuples(); ++i)
  {
    const bool isBlank = (i % (size[0] - 1) / 7 + i / (size[0] - 1) % (size[1] - 1) / 6) % 2 == 0;
    flags->SetValue(i, isBlank ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  scene.mapper->SetInputData(image);
}

}

class ProcessorMarchingOfPieces
  : public ProcessorMarching
  , public testing::WithParamInterface<Change>
{
};

TEST_P(ProcessorMarchingOfPieces, IsThePictureOfTheShader)
{
  MapperScene scene(SmallTorso());
  GetParam().make(scene);
  ExpectSamePicture(scene);
}

INSTANTIATE_TEST_SUITE_P(EveryPart, ProcessorMarchingOfPieces,
  testing::Values(Change{ "TranslucentGeometry", PutGlassIn },
    Change{ "TranslucentGeometryInLightAndNoise",
      [](MapperScene& s)
      {
        PutGlassIn(s);
        s.volume->GetProperty()->ShadeOn();
        s.mapper->UseJitteringOn();
        s.mapper->SetFinalColorWindow(0.7f);
      } },
    Change{ "ABinaryMask", [](MapperScene& s) { UseMask(s, true); } },
    Change{ "ABinaryMaskInLight",
      [](MapperScene& s)
      {
        UseMask(s, true);
        s.volume->GetProperty()->ShadeOn();
      } },
    Change{ "ABinaryMaskOfIsosurfaces",
      [](MapperScene& s)
      {
        UseMask(s, true);
        ShowIsosurfaces(s);
      } },
    Change{ "Labels", UseLabels },
    Change{ "LabelsAtMidpointsInPart",
      [](MapperScene& s)
      {
        UseLabels(s);
        s.mapper->SetIntegrationRule(Mapper::Midpoint);
        s.mapper->SetMaskBlendFactor(0.4f);
      } },
    Change{ "LabelsInLightWithOpacityOfGradients",
      [](MapperScene& s)
      {
        UseLabels(s);
        LeaveLowerGradientsOut(s);
        s.volume->GetProperty()->ShadeOn();
        vtkNew<vtkPiecewiseFunction> factors;
        factors->AddPoint(0.0, 0.2);
        factors->AddPoint(100.0, 1.0);
        s.volume->GetProperty()->SetLabelGradientOpacity(2, factors);
      } },
    Change{ "LabelsLitAsSurfaces",
      [](MapperScene& s)
      {
        UseLabels(s);
        s.volume->GetProperty()->ShadeOn();
        s.mapper->LabelSurfacesOn();
      } },
    Change{ "LabelsOfBoxes",
      [](MapperScene& s)
      {
        UseLabels(s);
        ShowBoxes(s);
      } },
    Change{ "LabelsOverAFunctionOfValueAndGradientInPart",
      [](MapperScene& s)
      {
        UseLabels(s);
        ShowValueAndGradient(s);
        s.mapper->SetMaskBlendFactor(0.4f);
      } },
    Change{ "LabelsInACrop",
      [](MapperScene& s)
      {
        UseLabels(s);
        Crop(s);
      } },
    Change{ "Cropping", Crop },
    Change{ "CroppingAtMidpointsWithNoise",
      [](MapperScene& s)
      {
        Crop(s);
        s.mapper->SetIntegrationRule(Mapper::Midpoint);
        s.mapper->UseJitteringOn();
      } },
    Change{ "CroppingInLight",
      [](MapperScene& s)
      {
        Crop(s);
        s.volume->GetProperty()->ShadeOn();
      } },
    Change{ "CroppingOfBoxes",
      [](MapperScene& s)
      {
        Crop(s);
        ShowBoxes(s);
      } },
    Change{ "Gaps", [](MapperScene& s) { MakeGaps(s, VTK_FLOAT); } },
    Change{ "GapsOfDoublesInColor",
      [](MapperScene& s)
      {
        MakeGaps(s, VTK_DOUBLE);
        s.mapper->SetNanOpacity(0.02);
        s.mapper->SetNanColor(0.1, 0.9, 0.4);
        s.mapper->SetIntegrationRule(Mapper::Midpoint);
      } },
    Change{ "GapsBetweenBoxesInACrop",
      [](MapperScene& s)
      {
        MakeGaps(s, VTK_FLOAT);
        ShowBoxes(s);
        Crop(s);
      } },
    Change{ "BlankedCells", BlankCells },
    Change{ "BlankedCellsInLight",
      [](MapperScene& s)
      {
        BlankCells(s);
        s.volume->GetProperty()->ShadeOn();
        LeaveLowerGradientsOut(s);
      } },
    Change{ "BlankedIsosurfacesOfAMask",
      [](MapperScene& s)
      {
        BlankCells(s);
        ShowIsosurfaces(s);
        UseMask(s, true);
      } },
    Change{ "AMaximumInACrop",
      [](MapperScene& s)
      {
        Crop(s);
        ShowUpperValues(s);
        s.mapper->SetBlendModeToMaximumIntensity();
      } },
    Change{ "AMinimumOfAMask",
      [](MapperScene& s)
      {
        UseMask(s, true);
        s.mapper->SetBlendModeToMinimumIntensity();
        s.opacities->RemoveAllPoints();
        s.opacities->AddPoint(-1100.0, 0.0);
        s.opacities->AddPoint(100.0, 1.0);
      } },
    Change{ "AMaximumOfBoxesBetweenGaps",
      [](MapperScene& s)
      {
        MakeGaps(s, VTK_FLOAT);
        ShowBoxes(s);
        ShowUpperValues(s);
        s.mapper->SetBlendModeToMaximumIntensity();
      } },
    Change{ "AMeanOfAMaskInACrop",
      [](MapperScene& s)
      {
        UseMask(s, true);
        Crop(s);
        s.mapper->SetBlendModeToAverageIntensity();
      } },
    Change{ "ASumOfBlankedCells",
      [](MapperScene& s)
      {
        BlankCells(s);
        s.mapper->SetBlendModeToAdditive();
      } },
    Change{ "CroppingOfIsosurfaces",
      [](MapperScene& s)
      {
        Crop(s);
        ShowIsosurfaces(s);
      } }),
  NameOf);

// NaN must not survive a weight of 0.
TEST(ComponentCopy, HasZerosForWhatIsNotANumber)
{
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfComponents(2);
  values->InsertNextTuple2(1.0, 2.0);
  values->InsertNextTuple2(3.0, std::numeric_limits<double>::quiet_NaN());
  values->InsertNextTuple2(std::numeric_limits<double>::infinity(), 6.0);
  const ComponentCopy first = CopyAsFloats({ values, 0 });
  const ComponentCopy second = CopyAsItIs({ values, 1 });
  const double expected[2][3] = { { 1.0, 3.0, 0.0 }, { 2.0, 0.0, 6.0 } };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(first.array->GetComponent(i, 0), expected[0][i]);
    EXPECT_EQ(second.array->GetComponent(i, 0), expected[1][i]);
  }
  EXPECT_FALSE(first.allFinite);
  EXPECT_FALSE(second.allFinite);
  EXPECT_EQ(first.array->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(second.array->GetDataType(), VTK_DOUBLE);
}
