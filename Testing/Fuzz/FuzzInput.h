#ifndef Varimarch_Testing_Fuzz_FuzzInput_h
#define Varimarch_Testing_Fuzz_FuzzInput_h

#include "Module/Files/PhantomFiles.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// The line between the files of an input that stands for several files.
extern const std::string FileBoundary;

/// An input that stands for several files.
std::string JoinedFiles(const std::vector<std::string>& files);

/// A private folder in memory whose files are those of the current input.
class InputFolder
{
public:
  InputFolder();

  /// Replaces all files by those of an input.
  /// @param names  names of the files in their order; further files of the input are left out
  void Replace(const std::vector<std::string>& names, const std::string& input);

  /// Path of a file; of the folder for an empty name.
  std::string Path(const std::string& name) const;

private:
  TemporaryFolder folder;
};

/// The one folder of this process.
InputFolder& Inputs();

/// Numbers that an input chooses. Behind its end all of them are the least possible. Arguments in
/// braces are evaluated in their order, those in parentheses are not: an input would mean something
/// else to another compiler.
class ChosenNumbers
{
public:
  explicit ChosenNumbers(const std::string& input)
    : input(input)
  {
  }

  /// A whole number from `least` to `most`, which differ by less than 2^16.
  int Integer(int least, int most);
  /// One of 2^16 equidistant numbers from `least` to `most`.
  double Number(double least, double most);
  bool Flag() { return this->Integer(0, 1) == 1; }
  bool IsAtEnd() const { return this->next >= this->input.size(); }

  template <class Choice, std::size_t count>
  Choice Of(const Choice (&choices)[count])
  {
    return choices[this->Integer(0, int(count) - 1)];
  }

private:
  unsigned Bits16();

  const std::string& input;
  std::size_t next = 0;
};

/// Seeds for targets that read ChosenNumbers: random bytes.
std::vector<std::string> RandomInputs(int count, std::size_t byteCount);

}

#endif
