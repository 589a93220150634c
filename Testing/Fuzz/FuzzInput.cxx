#include "Fuzz/FuzzInput.h"

#include <filesystem>
#include <random>

namespace varimarch
{

const std::string FileBoundary = "\n==== next file ====\n";

std::string JoinedFiles(const std::vector<std::string>& files)
{
  std::string input;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    input += (i > 0 ? FileBoundary : "") + files[i];
  }
  return input;
}

InputFolder::InputFolder()
{
  std::filesystem::create_directories(this->Path(""));
}

void InputFolder::Replace(const std::vector<std::string>& names, const std::string& input)
{
  for (const auto& old : std::filesystem::directory_iterator(this->Path("")))
  {
    std::filesystem::remove_all(old.path());
  }
  std::size_t begin = 0;
  for (const std::string& name : names)
  {
    const std::size_t boundary = names.size() > 1 ? input.find(FileBoundary, begin) : input.npos;
    this->folder.Write("input/" + name, input.substr(begin, boundary - begin));
    if (boundary == input.npos)
    {
      break;
    }
    begin = boundary + FileBoundary.size();
  }
}

std::string InputFolder::Path(const std::string& name) const
{
  return this->folder.Path(name.empty() ? "input" : "input/" + name);
}

InputFolder& Inputs()
{
  static InputFolder inputs;
  return inputs;
}

unsigned ChosenNumbers::Bits16()
{
  unsigned bits = 0;
  for (int byte = 0; byte < 2; ++byte)
  {
    const char next = this->IsAtEnd() ? '\0' : this->input[this->next];
    ++this->next;
    bits = 256 * bits + static_cast<unsigned char>(next);
  }
  return bits;
}

int ChosenNumbers::Integer(int least, int most)
{
  return least + int(this->Bits16() % unsigned(most - least + 1));
}

double ChosenNumbers::Number(double least, double most)
{
  return least + this->Bits16() / 65535.0 * (most - least);
}

std::vector<std::string> RandomInputs(int count, std::size_t byteCount)
{
  std::mt19937 random(20251125);
  std::vector<std::string> inputs;
  for (int i = 0; i < count; ++i)
  {
    std::string bytes(byteCount, '\0');
    for (char& byte : bytes)
    {
      byte = char(random());
    }
    inputs.push_back(bytes);
  }
  return inputs;
}

}
