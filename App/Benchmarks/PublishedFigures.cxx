#include "PublishedFigures.h"

#include "CommandLine/PictureError.h"
#include "CommandLine/Results.h"
#include "Core/Fields/VariationField.h"
#include "PublishedScenes.h"
#include "Scene/Canvas.h"
#include "Scene/ImageFiles.h"
#include "Scene/OffscreenView.h"
#include "Scene/VariationImage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace varimarch
{

namespace
{

constexpr const char* Bonsai = "bonsai/bonsai_256x256x256_uint8.mhd";
constexpr int Side = 128; // voxels along each axis, the smaller size of the paper

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

/// Draws one volume with the paper's loop.
class Stage
{
public:
  Stage(const std::string& path, int side)
    : volume(LoadAtSize(path, Side))
  {
    this->scene.size = { side, side };
    this->scene.look = SoftLook(this->Volume());
  }

  vtkImageData* Volume() { return this->volume.image; }

  // Hard edges, on which skipped values show: clear below a threshold, dense above it.
  void UseHardLook(double threshold)
  {
    Look& look = this->scene.look;
    look.opacities = { { threshold, 0.0, {} }, { threshold + 0.02, 0.6, {} } };
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

  LoadedVolume volume;
  Scene scene;
};

RenderOptions Plain(Stage& stage, int mostSteps = 0)
{
  RenderOptions options = PublishedLoop(stage.Volume(), false, 0.0);
  options.mostSteps = mostSteps;
  return options;
}

PublishedFigure Figure5(const std::string& folder, const std::string& volumes, int side)
{
  Stage stage(volumes + "/" + VisMaleFile, side);
  std::vector<Tile> tiles;
  for (const int steps : { 20, 120 })
  {
    tiles.push_back(
      stage.Draw(std::to_string(steps) + " steps", stage.VoxelsAlong() / steps, Plain(stage)));
  }
  WritePng(Sheet({ tiles }, side), folder + "/figure-5.png");
  return { "figure-5.png",
    "Figure 5, the number of steps: VIS MALE with so many steps along its longest edge." };
}

PublishedFigure Figure6(const std::string& folder, const std::string& volumes, int side)
{
  Stage stage(volumes + "/" + VisMaleFile, side);
  const std::vector<Tile> tiles = { stage.Draw("60 steps of a voxel", 1.0, Plain(stage, 60)),
    stage.Draw("no limit", 1.0, Plain(stage)) };
  WritePng(Sheet({ tiles }, side), folder + "/figure-6.png");
  return { "figure-6.png",
    "Figure 6, a short range: rays end after 60 steps of one voxel, and the far half is missing." };
}

// Long steps between two views that are close, and the paper's first cure.
PublishedFigure Figure7(const std::string& folder, const std::string& volumes, int side)
{
  constexpr double LongStep = 12.0;
  Stage stage(volumes + "/" + Bonsai, side);
  stage.UseHardLook(0.35);
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
  WritePng(Sheet({ plain, cured }, side), folder + "/figure-7.png");
  return { "figure-7.png",
    "Figure 7, steps that are too long: steps of 12 voxels, from 0 and 2 degrees; thin branches "
    "come and go with the camera. Below, the "
    "first "
    "cure of the paper: fine steps to an opacity above 50 %, then 8 samples." };
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

PublishedFigure Figure9(const std::string& folder, const std::string& volumes)
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
  WritePng(Sheet({ slices, fields }, Side), folder + "/figure-9.png");
  return { "figure-9.png",
    "Figure 9, slices of VIS MALE and their field S for E = 4/255: black is a distance of 0, white "
    "one of 32 voxels or more." };
}

PublishedFigure Figure10(const std::string& folder, const std::string& volumes, int side)
{
  Stage stage(volumes + "/" + VisMaleFile, side);
  stage.UseHardLook(0.25);
  const auto plain = stage.Image(1.0, Plain(stage));
  std::vector<Tile> tiles;
  std::string differences;
  for (const int variation : { 10, 4 })
  {
    const std::string name = "E = " + std::to_string(variation);
    const auto image = stage.Image(1.0, PublishedLoop(stage.Volume(), true, variation));
    tiles.push_back(stage.TileOf(name, image));
    differences +=
      (differences.empty() ? "" : ", ") + name + " " + Fixed(stage.Difference(image, plain), 2);
  }
  tiles.push_back(stage.TileOf("no field", plain));
  WritePng(Sheet({ tiles }, side), folder + "/figure-10.png");
  return { "figure-10.png",
    "Figure 10, E = 10/255 against 4/255, with a hard transfer function and steps of a voxel. RMSE "
    "from the same loop without a field, in 1/255: " +
      differences + "." };
}

}

std::vector<PublishedFigure> DrawPublishedFigures(
  const std::string& volumes, int side, const std::string& folder, const OnStep& onStep)
{
  std::vector<PublishedFigure> figures;
  onStep("Figures");
  if (std::filesystem::exists(volumes + "/" + VisMaleFile))
  {
    figures.push_back(Figure5(folder, volumes, side));
    figures.push_back(Figure6(folder, volumes, side));
    figures.push_back(Figure9(folder, volumes));
    figures.push_back(Figure10(folder, volumes, side));
  }
  if (std::filesystem::exists(volumes + "/" + Bonsai))
  {
    figures.push_back(Figure7(folder, volumes, side));
  }
  return figures;
}

}
