#include "Published.h"

#include "BenchMethods.h"
#include "CommandLine/PictureError.h"
#include "CommandLine/Results.h"
#include "Core/Fields/VariationField.h"
#include "Scene/Images/DifferencePicture.h"
#include "Scene/Images/ImageFiles.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Volumes/VariationImage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace varimarch
{

namespace
{

constexpr const char* Bonsai = "bonsai/bonsai_256x256x256_uint8.mhd";
constexpr int Side = 128;             // voxels along each axis, the smaller size of the paper
constexpr double BoneThreshold = 0.5; // relative value

/// A part of a figure: what is drawn in it, and its caption.
struct Tile
{
  std::string caption;
  vtkSmartPointer<vtkImageData> picture;
};

// Draws rows of tiles from the top, each with its caption below.
vtkSmartPointer<vtkImageData> Sheet(const std::vector<std::vector<Tile>>& rows, int side)
{
  constexpr int CaptionPixels = 22;
  constexpr int FontSize = 13;
  const int height = side + CaptionPixels;
  Canvas canvas(side * int(rows.front().size()), height * int(rows.size()), { 255, 255, 255 });
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    const int bottom = height * int(rows.size() - 1 - row);
    for (std::size_t column = 0; column < rows[row].size(); ++column)
    {
      const int left = side * int(column);
      canvas.Put(rows[row][column].picture, left, bottom + CaptionPixels);
      canvas.Write(
        rows[row][column].caption, left + side / 2, bottom + 6, FontSize, Canvas::Anchor::Middle);
    }
  }
  return canvas.Picture();
}

// Directions in which a volume stands upright: the first slice is the top of the head, and the rows
// of the bonsai go upwards.
constexpr double HeadUpright[9] = { -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0 };
constexpr double TreeUpright[9] = { 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0 };

/// Draws one volume with the paper's loop.
class Stage
{
public:
  Stage(const std::string& path, const double direction[9], int side)
    : volume(LoadAtSize(path, Side).image)
  {
    this->volume->SetDirectionMatrix(direction);
    this->scene.size = { side, side };
    this->scene.look = SoftLook(this->volume);
  }

  vtkImageData* Volume() { return this->volume; }

  // Replaces the volume by another one of the same size and unit; the look stays.
  void ReplaceVolume(vtkImageData* other)
  {
    this->scene.look = InUnitsOfData(this->scene.look, this->volume);
    this->volume = other;
  }

  // Hard edges, on which skipped values show: clear below a threshold, dense above it.
  void UseHardLook(double threshold)
  {
    Look& look = this->scene.look;
    look.opacities = { { threshold, 0.0, {} }, { threshold + 0.02, 0.6, {} } };
  }

  // A narrow peak, on which small differences of values show.
  void UsePeak(double value)
  {
    constexpr double HalfWidth = 0.02;
    this->scene.look.opacities = { { value - HalfWidth, 0.0, {} }, { value, 0.1, {} },
      { value + HalfWidth, 0.0, {} } };
  }

  void Turn(double degrees) { this->scene.camera.azimuthDegrees = degrees; }

  // The float image with steps of a length in smallest spacings.
  vtkSmartPointer<vtkImageData> Image(double voxels, const RenderOptions& options)
  {
    this->scene.render = AtDistance(this->Volume(), voxels, options).options;
    OffscreenView view(this->scene, this->Volume(), MapperKind::VarimarchShaders);
    return view.FloatImage();
  }

  Tile TileOf(const std::string& caption, vtkImageData* image)
  {
    return { caption, BytesOver(image, this->scene.background) };
  }

  Tile Draw(const std::string& caption, double voxels, const RenderOptions& options)
  {
    return this->TileOf(caption, this->Image(voxels, options));
  }

  // The RMSE between two images [1/255].
  double Difference(vtkImageData* one, vtkImageData* other)
  {
    return ErrorOf(one, other, this->scene.background).light.rootMeanSquare;
  }

  double VoxelsAlong() { return this->LongestEdgeMm() / VoxelMm(this->Volume()); }

private:
  double LongestEdgeMm()
  {
    const double* const b = this->Volume()->GetBounds();
    return std::max({ b[1] - b[0], b[3] - b[2], b[5] - b[4] });
  }

  vtkSmartPointer<vtkImageData> volume;
  Scene scene;
};

RenderOptions Plain(Stage& stage, int mostSteps = 0)
{
  RenderOptions options = PublishedLoop(stage.Volume(), false, 0.0);
  options.mostSteps = mostSteps;
  return options;
}

// A volume of bytes whose values are rounded to those that so many bits can hold, over the same
// range.
vtkSmartPointer<vtkImageData> RoundedTo(int bits, vtkImageData* bytes)
{
  constexpr double Largest = 255.0;
  const double step = Largest / ((1 << bits) - 1);
  auto rounded = vtkSmartPointer<vtkImageData>::New();
  rounded->DeepCopy(bytes);
  auto* const voxels = static_cast<unsigned char*>(rounded->GetScalarPointer());
  std::transform(voxels, voxels + rounded->GetNumberOfPoints(), voxels,
    [&](unsigned char value)
    { return static_cast<unsigned char>(std::lround(std::round(value / step) * step)); });
  return rounded;
}

PublishedFigure Figure3(const std::filesystem::path& folder, const std::string& volumes, int side)
{
  Stage stage(volumes + "/" + VisMaleFile, HeadUpright, side);
  stage.UseHardLook(BoneThreshold);
  const vtkSmartPointer<vtkImageData> bytes = stage.Volume();
  const auto whole = stage.Image(0.5, Plain(stage));
  std::vector<Tile> tiles = { stage.TileOf("8 bits", whole) };
  std::string differences;
  for (const int bits : { 6, 4, 1 })
  {
    const std::string name = std::to_string(bits) + (bits == 1 ? " bit" : " bits");
    stage.ReplaceVolume(RoundedTo(bits, bytes));
    const auto image = stage.Image(0.5, Plain(stage));
    tiles.push_back(stage.TileOf(name, image));
    differences +=
      (differences.empty() ? "" : ", ") + name + " " + Fixed(stage.Difference(image, whole), 2);
  }
  WritePng(Sheet({ { tiles[0], tiles[1] }, { tiles[2], tiles[3] } }, side),
    (folder / "figure-3.png").string());
  return { "figure-3.png",
    "Figure 3, the bits of a voxel: VIS MALE with voxels rounded to 8, 6, 4 and 1 bits, a hard "
    "transfer function and steps of half a voxel. RMSE from the image of 8 bits, in 1/255: " +
      differences + "." };
}

PublishedFigure Figure5(const std::filesystem::path& folder, const std::string& volumes, int side)
{
  Stage stage(volumes + "/" + VisMaleFile, HeadUpright, side);
  std::vector<Tile> tiles;
  for (const int steps : { 20, 120 })
  {
    tiles.push_back(
      stage.Draw(std::to_string(steps) + " steps", stage.VoxelsAlong() / steps, Plain(stage)));
  }
  WritePng(Sheet({ tiles }, side), (folder / "figure-5.png").string());
  return { "figure-5.png",
    "Figure 5, the number of steps: VIS MALE with so many steps along its longest edge." };
}

PublishedFigure Figure6(const std::filesystem::path& folder, const std::string& volumes, int side)
{
  Stage stage(volumes + "/" + VisMaleFile, HeadUpright, side);
  const std::vector<Tile> tiles = { stage.Draw("60 steps of a voxel", 1.0, Plain(stage, 60)),
    stage.Draw("no limit", 1.0, Plain(stage)) };
  WritePng(Sheet({ tiles }, side), (folder / "figure-6.png").string());
  return { "figure-6.png",
    "Figure 6, a short range: rays end after 60 steps of one voxel, and the far half is missing." };
}

// Long steps between two views that are close, and the paper's first cure.
PublishedFigure Figure7(const std::filesystem::path& folder, const std::string& volumes, int side)
{
  constexpr double LongStep = 6.0;
  constexpr double BranchThreshold = 0.3;
  Stage stage(volumes + "/" + Bonsai, TreeUpright, side);
  stage.UseHardLook(BranchThreshold);
  std::vector<Tile> plain;
  std::vector<Tile> cured;
  for (const int degrees : { 0, 2 })
  {
    stage.Turn(degrees);
    const std::string view = " " + std::to_string(degrees) + " deg";
    RenderOptions cure = Plain(stage, 8);
    cure.integration = Integration::FirstHit;
    plain.push_back(stage.Draw("long steps," + view, LongStep, Plain(stage)));
    cured.push_back(stage.Draw("first hit," + view, LongStep, cure));
  }
  WritePng(Sheet({ plain, cured }, side), (folder / "figure-7.png").string());
  return { "figure-7.png",
    "Figure 7, steps that are too long: steps of 6 voxels, from 0 and 2 degrees; thin branches "
    "come and go with the camera. Below, the first cure of the paper: fine steps to an opacity "
    "above 50 %, then 8 samples." };
}

// A slice of a volume of bytes across z, with values scaled to 0..255.
Tile SliceOf(vtkImageData* bytes, int z, const std::string& caption, double scale)
{
  const int* const size = bytes->GetDimensions();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* voxel = static_cast<unsigned char*>(bytes->GetScalarPointer(0, 0, z));
  auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    const auto grey = static_cast<unsigned char>(std::min(scale * voxel[i], 255.0));
    std::fill_n(pixel + 3 * i, 3, grey);
  }
  return { caption, picture };
}

PublishedFigure Figure9(const std::filesystem::path& folder, const std::string& volumes)
{
  constexpr double Brightest = 32.0; // distance in voxels that is white
  const LoadedVolume volume = LoadAtSize(volumes + "/" + VisMaleFile, Side);
  const auto field = VariationImage(
    volume.image, Variation(volume.image, PublishedVariation255), VoxelDistance::Euclidean);
  std::vector<Tile> slices;
  std::vector<Tile> fields;
  for (const int z : { Side / 4, Side / 2, 3 * Side / 4 })
  {
    const std::string name = "slice " + std::to_string(z);
    slices.push_back(SliceOf(volume.image, z, name, 1.0));
    fields.push_back(SliceOf(field, z, name + ", its field", 255.0 / Brightest));
  }
  WritePng(Sheet({ slices, fields }, Side), (folder / "figure-9.png").string());
  return { "figure-9.png",
    "Figure 9, slices of VIS MALE and their field S for E = 4/255: black is a distance of 0, white "
    "one of 32 voxels or more." };
}

PublishedFigure Figure10(const std::filesystem::path& folder, const std::string& volumes, int side)
{
  Stage stage(volumes + "/" + VisMaleFile, HeadUpright, side);
  stage.UsePeak(0.44); // a little above most of the tissue
  const auto plain = stage.Image(1.0, Plain(stage));
  std::vector<Tile> images;
  std::vector<Tile> errors;
  std::string numbers;
  for (const int variation : { 10, 4 })
  {
    const std::string name = "E = " + std::to_string(variation);
    const auto image = stage.Image(1.0, PublishedLoop(stage.Volume(), true, variation));
    images.push_back(stage.TileOf(name, image));
    errors.push_back({ name + ", difference", DifferencePicture(image, plain) });
    numbers +=
      (numbers.empty() ? "" : ", ") + name + " " + Fixed(stage.Difference(image, plain), 2);
  }
  WritePng(Sheet({ images, errors }, side), (folder / "figure-10.png").string());
  return { "figure-10.png",
    "Figure 10, E = 10/255 against 4/255, with a narrow peak above the values of most tissue and "
    "steps of a voxel. Below, the differences from the same loop without a field, from 0.1 (blue) "
    "to 100 of 255 (yellow) on a logarithmic scale. Their RMSE in 1/255: " +
      numbers + "." };
}

}

std::vector<PublishedFigure> DrawPublishedFigures(
  const std::string& volumes, int side, const std::filesystem::path& folder, const OnStep& onStep)
{
  std::vector<PublishedFigure> figures;
  onStep("Figures");
  if (std::filesystem::exists(volumes + "/" + VisMaleFile))
  {
    figures.push_back(Figure3(folder, volumes, side));
    figures.push_back(Figure5(folder, volumes, side));
    figures.push_back(Figure6(folder, volumes, side));
  }
  if (std::filesystem::exists(volumes + "/" + Bonsai))
  {
    figures.push_back(Figure7(folder, volumes, side));
  }
  if (std::filesystem::exists(volumes + "/" + VisMaleFile))
  {
    figures.push_back(Figure9(folder, volumes));
    figures.push_back(Figure10(folder, volumes, side));
  }
  return figures;
}

}
