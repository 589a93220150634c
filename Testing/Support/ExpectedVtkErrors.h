#ifndef Varimarch_Testing_ExpectedVtkErrors_h
#define Varimarch_Testing_ExpectedVtkErrors_h

#include <string>
#include <vector>

/// While one of these lives, errors and warnings that VTK reports are collected here instead of
/// failing the test. Tests of bad input look at them.
class ExpectedVtkErrors
{
public:
  ExpectedVtkErrors();
  ~ExpectedVtkErrors();
  ExpectedVtkErrors(const ExpectedVtkErrors&) = delete;
  void operator=(const ExpectedVtkErrors&) = delete;

  /// Every message since construction, as VTK words it.
  const std::vector<std::string>& Messages() const { return this->messages; }

  /// The messages as one text.
  std::string Text() const;

private:
  friend class CollectingOutputWindow;
  std::vector<std::string> messages;
};

#endif
