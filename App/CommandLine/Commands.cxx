#include "Commands.h"

#include "AddArchiveCommand.h"
#include "Parser.h"
#include "Scene/Json/SceneNames.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace varimarch
{

namespace
{

void AddLabelOptions(CLI::App& command, LabelArguments& arguments)
{
  const std::string group = "Labels";
  command
    .add_option("--labels", arguments.path,
      "Segmentation of the scan: DICOM SEG, .seg.nrrd, or a label map of any format")
    ->type_name("FILE")
    ->group(group);
  command
    .add_option("--label-colors", arguments.colorTable,
      "Names and colours of the labels, as 3D Slicer (.ctbl), ITK-SNAP and FreeSurfer write them")
    ->type_name("FILE")
    ->group(group);
}

void AddOverlayOption(CLI::App& command, std::vector<std::string>& paths)
{
  command
    .add_option("--overlay", paths,
      "A further scan in the same space, drawn in one march with the first, such as a PET\n"
      "over its CT; may be repeated. Scenes give it a look and a place")
    ->type_name("FILE")
    ->expected(1)
    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
    ->group("Volume");
}

void AddPictureFileOptions(CLI::App& command, RenderArguments& arguments)
{
  command
    .add_option("-o,--output", arguments.outputPath,
      "The image to write: PNG (.png), or a DICOM secondary capture without data\n"
      "of the patient (.dcm)")
    ->type_name("FILE")
    ->required();
  command.add_flag("--overwrite", arguments.overwrites, "Replace an existing DICOM file");
}

void AddRenderCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<RenderArguments>();
  arguments->commandText = commandText;
  CLI::App* app = program.add_subcommand("render", "Draw a volume or a scene into an image file");
  app->footer(
    "Examples:\n"
    "  varimarch render head.nii.gz -o head.png\n"
    "  varimarch render dicom-folder -o bone.png --preset ct-bone --view left --zoom 1.3\n"
    "  varimarch render scan.raw --raw-dimensions 256x256x128 --raw-type uint16 -o scan.png\n"
    "  varimarch render procedural:torso:256x192x192 -o torso.png --azimuth 30\n"
    "  varimarch render ct-folder -o organs.png --labels organs.seg.nrrd\n"
    "  varimarch render scene.json -o scene.png --size 1024x1024 --renderer vtk-gpu\n"
    "  varimarch render dicom-folder -o bone.dcm --preset ct-bone");
  AddSceneOptions(*app, arguments->scene);
  AddLabelOptions(*app, arguments->labels);
  AddOverlayOption(*app, arguments->overlays);
  AddPictureFileOptions(*app, *arguments);
  app
    ->add_option_function<std::string>(
      "--renderer",
      [arguments](const std::string& name)
      { arguments->renderer = ValueOf(MapperKindNames(), name); },
      "The mapper that draws (default ours)")
    ->check(OneOf(NamesOf(MapperKindNames())))
    ->group("Sampling");
  app
    ->add_option("--graphics-memory", arguments->graphicsMegabytes,
      "Limit for our mapper in MB; larger volumes are drawn in blocks (default: none)")
    ->check(CLI::NonNegativeNumber)
    ->group("Sampling");
  app->add_option("--repeat", arguments->repeats, "Number of further frames for the median time")
    ->check(CLI::NonNegativeNumber)
    ->group("Sampling");
  AddJsonOption(*app, arguments->jsonPath);
  app->callback([arguments] { RunRender(*arguments); });
}

void AddCompareCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<CompareArguments>();
  arguments->commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "compare", "Draw with our mapper and VTK's, and report the time and the error of each");
  app->footer(
    "Writes a PNG of each renderer and of its difference from the truth,\n"
    "side-by-side.png, and compare.csv, compare.json and compare.md.\n"
    "Examples:\n"
    "  varimarch compare head.nii.gz -o comparison\n"
    "  varimarch compare dicom-folder -o comparison --preset ct-bone --rounds 9\n"
    "  varimarch compare procedural:torso -o comparison --size 256x256 --sample-distance 1");
  AddSceneOptions(*app, arguments->scene);
  app->add_option("-o,--output", arguments->outputFolder, "The folder for images and tables")
    ->type_name("FOLDER")
    ->required();
  app->add_option("--rounds", arguments->rounds, "Number of frames of each (default 5)")
    ->check(CLI::Range(1, 10000).description(""))
    ->type_name("N");
  app
    ->add_option("--paths", arguments->paths.paths,
      "Compare with light that matter scatters, traced by N random paths for each pixel")
    ->check(CLI::Range(2, 1000000).description(""))
    ->type_name("N");
  app
    ->add_option("--scatterings", arguments->paths.mostScatterings,
      "Largest number of times that a path is scattered (default: any)")
    ->check(CLI::Range(1, 1000000).description(""))
    ->type_name("N")
    ->needs("--paths");
  AddJsonOption(*app, arguments->jsonPath);
  app->callback([arguments] { RunCompare(*arguments); });
}

void AddInfoCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<InfoArguments>();
  arguments->commandText = commandText;
  CLI::App* app =
    program.add_subcommand("info", "Describe a volume and the distribution of its values");
  app->footer("Examples:\n"
              "  varimarch info head.nii.gz\n"
              "  varimarch info dicom-folder --bins 64\n"
              "  varimarch info dicom-folder --series 2\n"
              "  varimarch info ct.nii.gz --labels organs.nii.gz\n"
              "  varimarch info scan.raw --raw-dimensions 256x256x128 --json scan.json");
  AddVolumeOptions(*app, arguments->volume,
    "A volume file, a folder with a DICOM series, or\n"
    "procedural:shells|marschner-lobb|torso|checkerboard|ramp[:XxYxZ]");
  AddLabelOptions(*app, arguments->labels);
  app->add_option("--bins", arguments->bins, "Number of histogram bars (default 32)")
    ->check(CLI::Range(1, 65536).description(""))
    ->type_name("N");
  AddJsonOption(*app, arguments->jsonPath);
  app->callback([arguments] { RunInfo(*arguments); });
}

void AddConvertCommand(CLI::App& program)
{
  const auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* app = program.add_subcommand("convert", "Write a volume in another format");
  app->footer(
    "Voxels, spacing, position and directions are kept; TIFF holds only the spacing, and\n"
    "OME-Zarr no directions.\n"
    "Examples:\n"
    "  varimarch convert dicom-folder head.nii.gz\n"
    "  varimarch convert dicom-folder head.nrrd --series 2 --rectify\n"
    "  varimarch convert slices-folder slices.mha\n"
    "  varimarch convert brain.h5 brain.zarr --channel 1\n"
    "  varimarch convert scan.raw scan.vti --raw-dimensions 256x256x128 --raw-type uint16");
  AddVolumeOptions(*app, arguments->volume,
    "A volume file, a folder with a DICOM series or with pictures of slices, or\n"
    "procedural:shells|marschner-lobb|torso|checkerboard|ramp[:XxYxZ]");
  app
    ->add_option("OUTPUT", arguments->output.path,
      "The file to write: NIfTI (.nii, .nii.gz), NRRD (.nrrd), MetaImage (.mha),\n"
      "VTK image (.vti), OME-TIFF (.tif, .tiff) or OME-Zarr with its levels (.zarr)")
    ->required();
  app->add_flag("--overwrite", arguments->output.overwrites, "Replace an existing file");
  app->callback([arguments] { RunConvert(*arguments); });
}

void AddFieldCommand(CLI::App& program)
{
  const auto arguments = std::make_shared<FieldArguments>();
  CLI::App* app =
    program.add_subcommand("field", "Write how far each voxel's surroundings have about its value");
  app->footer(
    "The field of variations of Banquero, Ortiz and Rossi (2016): for each voxel the largest\n"
    "distance d, 1 to 255 voxels, such that all voxels closer than d differ from it by less than "
    "E.\n"
    "Examples:\n"
    "  varimarch field head.nii.gz -o field.nrrd --tolerance 40\n"
    "  varimarch field procedural:shells -o field.mha --tolerance 0.01 --distance chebyshev");
  AddVolumeOptions(*app, arguments->volume,
    "A volume file, a folder with a DICOM series, or\n"
    "procedural:shells|marschner-lobb|torso[:XxYxZ]");
  app
    ->add_option("-o,--output", arguments->output.path,
      "The file to write, in a format of varimarch convert; voxels are bytes")
    ->required()
    ->type_name("FILE");
  app->add_option("--tolerance", arguments->tolerance, "E in units of the data")
    ->required()
    ->check(CLI::NonNegativeNumber.description(""))
    ->type_name("E");
  app
    ->add_option_function<std::string>(
      "--distance",
      [arguments](const std::string& name)
      { arguments->distance = ValueOf(VoxelDistanceNames(), name); },
      "Shape of the surroundings: a ball (euclidean, the default) or a cube (chebyshev)")
    ->check(OneOf(NamesOf(VoxelDistanceNames())));
  app->add_flag("--overwrite", arguments->output.overwrites, "Replace an existing file");
  app->callback([arguments] { RunField(*arguments); });
}

void AddLookCommand(CLI::App& program)
{
  const auto arguments = std::make_shared<LookArguments>();
  CLI::App* app = program.add_subcommand("look", "Write a look for another program");
  app->footer("Values are in units of the data of the volume, which also decides on the look if "
              "none is named.\n"
              "Formats that hold only colours and opacities lose the rest of the look.\n"
              "Examples:\n"
              "  varimarch look dicom-folder bone.paraview.json --preset ct-bone\n"
              "  varimarch look scene.json scene.vp.json\n"
              "  varimarch look head.nii.gz head.json --transfer-function head.vp");
  AddVolumeOptions(*app, arguments->scene.volume,
    "A volume file, a folder with a DICOM series, a scene file (.json), or\n"
    "procedural:shells|marschner-lobb|torso[:XxYxZ]");
  app
    ->add_option("OUTPUT", arguments->output,
      "The file to write: Varimarch (.json), ParaView (.paraview.json),\n"
      "3D Slicer (.vp.json, .vp)")
    ->required();
  AddLookOptions(*app, arguments->scene);
  app->add_flag("--overwrite", arguments->overwrites, "Replace an existing file");
  app->callback([arguments] { RunLook(*arguments); });
}

}

void AddCommands(CLI::App& program, const std::string& commandText)
{
  AddRenderCommand(program, commandText);
  AddCompareCommand(program, commandText);
  AddInfoCommand(program, commandText);
  AddConvertCommand(program);
  AddFieldCommand(program);
  AddLookCommand(program);
  AddArchiveCommand(program);
}

}
