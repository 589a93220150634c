#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "Machine.h"
#include "Scene/OffscreenView.h"
#include "Scene/OutputFile.h"
#include "ShaderCost.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

nlohmann::ordered_json ToJson(const ProgramCost& cost)
{
  nlohmann::ordered_json json = { { "numbers", cost.numbers }, { "textures", cost.textures },
    { "binaryBytes", cost.binaryBytes } };
  if (cost.printed)
  {
    json["instructions"] = cost.printed->instructions;
    json["fetches"] = cost.printed->fetches;
    json["inputs"] = cost.printed->inputs;
  }
  return json;
}

nlohmann::ordered_json ToJson(const std::vector<ShaderCost>& costs)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ShaderCost& cost : costs)
  {
    json.push_back({ { "recipe", cost.recipe } });
    if (cost.plain)
    {
      json.back()["plain"] = ToJson(*cost.plain);
    }
    if (cost.lit)
    {
      json.back()["lit"] = ToJson(*cost.lit);
    }
  }
  return json;
}

std::string Cells(const std::optional<ProgramCost>& cost)
{
  if (!cost)
  {
    return " - | - | - | - | - |";
  }
  const auto cell = [](const std::string& text) { return " " + text + " |"; };
  const auto printed = [&](int PrintedShader::*number)
  { return cell(cost->printed ? std::to_string((*cost->printed).*number) : "-"); };
  return printed(&PrintedShader::instructions) + printed(&PrintedShader::fetches) +
    printed(&PrintedShader::inputs) + cell(std::to_string(cost->textures)) +
    cell(std::to_string(cost->binaryBytes));
}

// The factor of instructions by which light makes a shader longer.
std::string LitOverPlain(const ShaderCost& cost)
{
  const bool known = cost.lit && cost.lit->printed && cost.plain && cost.plain->printed;
  return known
    ? Fixed(double(cost.lit->printed->instructions) / cost.plain->printed->instructions, 2)
    : "-";
}

std::string Markdown(
  const std::vector<ShaderCost>& costs, const std::string& commandText, const std::string& device)
{
  std::string text = "# Cost of each shader\n\nOpenGL renderer \"" + device + "\", " +
    ThisMachine().date + ". Made by\n\n    " + commandText +
    "\n\nWhat the driver says of the program that marches rays, without light and with it: "
    "instructions of the fragment shader as Mesa hands it to the driver, without constants and "
    "addresses; those of them that read a texture; vectors of four numbers that the vertex shader "
    "hands on; textures; and the length of the program's binary [bytes], 0 if the driver has none. "
    "\"-\": not known.\n\n| recipe | plain: instructions | fetches | inputs | textures | binary "
    "| lit: instructions | fetches | inputs | textures | binary | lit / plain |\n"
    "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const ShaderCost& cost : costs)
  {
    text += "| " + cost.recipe + " |" + Cells(cost.plain) + Cells(cost.lit) + " " +
      LitOverPlain(cost) + " |\n";
  }
  return text;
}

}

void RunShaderCosts(const ShaderCostArguments& arguments)
{
  LetMesaPrintShaders();
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  const auto [scene, volume] = LoadScene(arguments.scene, arguments.input);
  std::vector<ShaderCost> costs;
  {
    Progress progress("Compiling shaders");
    costs = CostsOfShaders(
      scene, volume.image, [&](const std::string& step) { progress.SetActivity(step); });
  }
  const std::string device =
    OffscreenView(scene, volume.image, MapperKind::VarimarchShaders).DeviceName();
  const nlohmann::ordered_json results = { { "command", arguments.report.commandText },
    { "openglRenderer", device }, { "shaders", ToJson(costs) } };
  WriteResults(results, folder / "shaders.json");
  WriteResults(results, arguments.report.jsonPath);
  const std::string text = Markdown(costs, arguments.report.commandText, device);
  WriteFileWhole(folder / "shaders.md", text);
  std::cout << text;
}

}
