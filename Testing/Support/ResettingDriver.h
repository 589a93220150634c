#ifndef Varimarch_Testing_ResettingDriver_h
#define Varimarch_Testing_ResettingDriver_h

/// Answers in place of the driver of OpenGL, during its lifetime and to its thread, that the
/// graphics card was reset.
class ResettingDriver
{
public:
  /// @param count  number of questions that are answered so; further ones deny it
  explicit ResettingDriver(int count);
  ~ResettingDriver();
  ResettingDriver(const ResettingDriver&) = delete;
  void operator=(const ResettingDriver&) = delete;

  /// False if the driver has no such answer, so that nobody asks it. Needs a context.
  static bool CanTell();
};

#endif
