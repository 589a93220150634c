#ifndef Varimarch_Testing_ExpectedVtkErrors_h
#define Varimarch_Testing_ExpectedVtkErrors_h

#include "Readers/Parsing/VtkMessages.h"

#include <string>
#include <vector>

/// During its lifetime, errors and warnings that VTK reports are collected here instead of failing
/// the test, so that tests of bad input can check them.
class ExpectedVtkErrors
{
public:
  ExpectedVtkErrors();
  ~ExpectedVtkErrors();
  ExpectedVtkErrors(const ExpectedVtkErrors&) = delete;
  void operator=(const ExpectedVtkErrors&) = delete;

  /// Every message since construction, in VTK's wording.
  const std::vector<std::string>& Messages() const { return this->messages; }

  /// The messages as one text.
  std::string Text() const;

private:
  std::vector<std::string> messages;
  varimarch::VtkMessages caught;
};

#endif
