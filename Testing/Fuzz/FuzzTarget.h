#ifndef Varimarch_Testing_Fuzz_FuzzTarget_h
#define Varimarch_Testing_Fuzz_FuzzTarget_h

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// An entry of the program for inputs that are not trusted. libFuzzer and the regression test run
/// the same ones.
struct FuzzTarget
{
  std::string name;
  /// Runs the target on an input. Returns true if it was accepted, false if it was refused as it
  /// should be.
  /// @throws std::logic_error if the program did not keep a promise
  std::function<bool(const std::string& input)> run;
  /// Small inputs that are accepted.
  std::function<std::vector<std::string>()> seeds;
  std::vector<std::string> words; ///< words of the format, which mutations insert
};

/// Every target, sorted by subject.
std::vector<FuzzTarget> FuzzTargets();

/// @throws std::invalid_argument if there is none of that name
FuzzTarget FuzzTargetNamed(const std::string& name);

// The targets of each subject; a file for each.

std::vector<FuzzTarget> VolumeTargets();
std::vector<FuzzTarget> DicomTargets();
std::vector<FuzzTarget> LookTargets();
std::vector<FuzzTarget> SceneTargets();
std::vector<FuzzTarget> ArchiveTargets(); ///< empty without the library of archives
FuzzTarget RemoteTarget();
FuzzTarget RawGuessTarget();
FuzzTarget TransferFunctionTarget();
FuzzTarget FieldTarget();
FuzzTarget PacketTarget();
FuzzTarget RecipeTarget();

/// Throws std::logic_error with a text unless a property holds.
void Require(bool holds, const std::string& property);

/// Requires that the message of an error is one line.
void RequireOneLine(const std::string& message);

}

#endif
