#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkPointData.h>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

using namespace varimarch;

namespace
{

bool SameVoxels(vtkImageData* a, vtkImageData* b)
{
  return std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(),
           std::size_t(a->GetNumberOfPoints()) * a->GetScalarSize()) == 0;
}

double ValueAt(vtkImageData* image, double x, double y, double z)
{
  const double position[3] = { x, y, z };
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(position, index);
  return image->GetScalarComponentAsDouble(
    int(std::lround(index[0])), int(std::lround(index[1])), int(std::lround(index[2])), 0);
}

// Mean over a small box, which averages the noise out.
double MeanAround(vtkImageData* image, double x, double y, double z)
{
  double sum = 0.0;
  for (int i = 0; i < 125; ++i)
  {
    sum += ValueAt(image, x + 3 * (i % 5 - 2), y + 3 * (i / 5 % 5 - 2), z + 3 * (i / 25 - 2));
  }
  return sum / 125.0;
}

TEST(ProceduralVolume, SameSourceGivesSameVoxelsWithAnyNumberOfThreads)
{
  for (const ProceduralKind kind : { ProceduralKind::Shells, ProceduralKind::MarschnerLobb,
         ProceduralKind::Torso, ProceduralKind::Checkerboard, ProceduralKind::Ramp })
  {
    const ProceduralSource source = { kind, { 33, 30, 27 }, 7 };
    const auto parallel = ProceduralVolume(source);
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(SameVoxels(parallel, ProceduralVolume(source)));
  }
}

TEST(ProceduralVolume, SeedChangesTheNoise)
{
  const auto one = ProceduralVolume({ ProceduralKind::Torso, { 32, 32, 32 }, 1 });
  EXPECT_FALSE(SameVoxels(one, ProceduralVolume({ ProceduralKind::Torso, { 32, 32, 32 }, 2 })));
}

TEST(ProceduralVolume, TorsoHasTheHounsfieldUnitsOfItsTissues)
{
  const auto torso = ProceduralVolume({ ProceduralKind::Torso, { 127, 87, 107 }, 1 });
  EXPECT_EQ(torso->GetScalarType(), VTK_SHORT);
  EXPECT_NEAR(MeanAround(torso, -180, -120, 0), -1000, 15) << "air";
  EXPECT_NEAR(MeanAround(torso, 42, -36, -34), 330, 60) << "contrast medium in the left ventricle";
  EXPECT_NEAR(MeanAround(torso, -58, 0, -140), 100, 60) << "liver";
  EXPECT_LT(MeanAround(torso, -100, -10, 20), -600) << "right lung";
  EXPECT_GT(MeanAround(torso, 0, 48, 0), 150) << "vertebra";
}

TEST(ProceduralVolume, TorsoNoiseHasItsStandardDeviation)
{
  const auto torso = ProceduralVolume({ ProceduralKind::Torso, { 64, 64, 64 }, 1 });
  double sum = 0.0;
  double squares = 0.0;
  constexpr int Count = 64 * 5; // a corner of air
  for (int i = 0; i < Count; ++i)
  {
    const double value = torso->GetScalarComponentAsDouble(i % 5, 0, i / 5, 0);
    sum += value;
    squares += value * value;
  }
  const double deviation = std::sqrt(squares / Count - sum * sum / Count / Count);
  EXPECT_NEAR(deviation, 12.0, 2.5);
}

TEST(ProceduralVolume, ShellsHaveTheirValues)
{
  const auto shells = ProceduralVolume({ ProceduralKind::Shells, { 101, 101, 101 }, 1 });
  for (int shell = 0; shell < 5; ++shell)
  {
    EXPECT_EQ(ValueAt(shells, 9.0 * shell + 4.5, 0, 0), 240 - 50 * shell);
    EXPECT_EQ(ValueAt(shells, 9.0 * shell, 0, 0), 0);
  }
  EXPECT_EQ(ValueAt(shells, 49, 49, 49), 0);
}

TEST(ProceduralVolume, MarschnerLobbFollowsItsFormula)
{
  const auto signal = ProceduralVolume({ ProceduralKind::MarschnerLobb, { 41, 41, 41 }, 1 });
  // At the origin rho(0) = cos(12 pi) = 1, so (1 - 0 + 0.25 * 2) / 2.5.
  EXPECT_NEAR(ValueAt(signal, 0, 0, 0), 0.6, 1e-6);
  EXPECT_NEAR(ValueAt(signal, 0, 0, 50), 0.2, 1e-6);
  // At radius 1 the inner cosine is 0, so the ripple is 1 again.
  EXPECT_NEAR(ValueAt(signal, 50, 0, -50), 1.0, 1e-6);
}

TEST(ProceduralVolume, NeighboursOnACheckerboardDiffer)
{
  const auto board = ProceduralVolume({ ProceduralKind::Checkerboard, { 5, 4, 6 }, 1 });
  for (int i = 0; i < 4 * 3 * 5; ++i)
  {
    const int x = i % 4;
    const int y = i / 4 % 3;
    const int z = i / 12;
    const double value = board->GetScalarComponentAsDouble(x, y, z, 0);
    EXPECT_EQ(value, (x + y + z) % 2 ? 255.0 : 0.0);
    EXPECT_EQ(board->GetScalarComponentAsDouble(x + 1, y, z, 0), 255.0 - value);
    EXPECT_EQ(board->GetScalarComponentAsDouble(x, y + 1, z, 0), 255.0 - value);
    EXPECT_EQ(board->GetScalarComponentAsDouble(x, y, z + 1, 0), 255.0 - value);
  }
}

TEST(ProceduralVolume, RampRisesLinearly)
{
  const auto ramp = ProceduralVolume({ ProceduralKind::Ramp, { 18, 3, 4 }, 1 });
  for (int x = 0; x < 18; ++x)
  {
    EXPECT_NEAR(ramp->GetScalarComponentAsDouble(x, x % 3, x % 4, 0), 15.0 * x, 1e-4);
  }
}

TEST(ProceduralVolume, RefusesImpossibleSizes)
{
  EXPECT_THROW(ProceduralVolume({ ProceduralKind::Shells, { 8, 1, 8 }, 1 }), std::invalid_argument);
  EXPECT_THROW(
    ProceduralVolume({ ProceduralKind::Shells, { 8, 8, 1025 }, 1 }), std::invalid_argument);
}

}
