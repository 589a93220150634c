#ifndef Varimarch_Frame_NumberCheck_h
#define Varimarch_Frame_NumberCheck_h

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace varimarch
{

/// Numbers that are farther from 0 have no meaning in a scene, and their products overflow floats.
constexpr double LargestSetting = 1e30;

/// A setting that is a number, with the numbers that have a meaning.
struct NumberSetting
{
  const char* setter; ///< The class and method that sets it.
  double least = -LargestSetting;
  double most = LargestSetting;
  double usual = 0.0; ///< The default, which stands for NaN.
};

/// Makes the numbers of VTK's objects usable while a frame is built: their setters accept NaN, and
/// many accept any number. A number out of range is replaced by the nearest one in it, NaN by the
/// default, and a sentence for the user is kept of each.
class NumberCheck
{
public:
  double Usable(const NumberSetting& setting, double found);
  /// The same for each of three numbers.
  glm::dvec3 Usable(const NumberSetting& setting, const double* found);
  /// Keeps another sentence, unless it is known.
  void Note(const std::string& sentence);

  /// The sentences that were kept.
  const std::vector<std::string>& Notes() const { return this->notes; }

private:
  std::vector<std::string> notes;
};

/// Sentences, each followed by a space.
std::string Joined(const std::vector<std::string>& sentences);

/// A number as sentences show it.
std::string TextOf(double number);
/// Three numbers in parentheses.
std::string TextOf(const glm::dvec3& numbers);

}

#endif
