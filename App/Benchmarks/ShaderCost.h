#ifndef Varimarch_Benchmarks_ShaderCost_h
#define Varimarch_Benchmarks_ShaderCost_h

#include "CommandLine/Truth.h"
#include "Scene/Scene.h"

#include <vtkImageData.h>

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A fragment shader as Mesa hands it to a driver.
struct PrintedShader
{
  int instructions = 0; ///< instructions, without constants and addresses
  int fetches = 0;      ///< instructions that read a texture
  int inputs = 0;       ///< vectors of four numbers from the vertex shader
};

/// The driver's figures of the program that marches the rays of a recipe.
struct ProgramCost
{
  int numbers = 0;     ///< numbers in its uniforms; those of a block count whether read or not
  int textures = 0;    ///< textures that it reads
  int binaryBytes = 0; ///< length of its binary; 0 if the driver has none
  std::optional<PrintedShader> printed; ///< empty if the driver is not Mesa
};

/// The cost of a recipe's shader, without light and with it.
struct ShaderCost
{
  std::string recipe;
  std::optional<ProgramCost> plain; ///< empty if the recipe is always lit
  std::optional<ProgramCost> lit;   ///< empty if the recipe is never lit
};

/// Asks Mesa, if it is the driver, to print the shaders that it compiles. It must be called before
/// there is any OpenGL.
void LetMesaPrintShaders();

/// The costs of the methods of the benchmarks that march rays by shaders, and of all features.
/// Nothing is timed.
std::vector<ShaderCost> CostsOfShaders(
  const Scene& scene, vtkImageData* image, const OnStep& onStep);

/// Counts instructions and fetches of the longest fragment shader that Mesa has printed.
void CountInstructions(const std::string& printed, ProgramCost& cost);

}

#endif
