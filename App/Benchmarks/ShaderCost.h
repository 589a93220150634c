#ifndef Varimarch_Benchmarks_ShaderCost_h
#define Varimarch_Benchmarks_ShaderCost_h

#include <functional>
#include <optional>
#include <string>

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

/// The text that this process, with all its libraries, writes to its standard error while something
/// is done.
std::string ErrorsDuring(const std::function<void()>& act);

/// Counts instructions and fetches of the longest fragment shader that Mesa has printed.
void CountInstructions(const std::string& printed, ProgramCost& cost);

}

#endif
