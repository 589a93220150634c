#include "CapturedErrors.h"

#include <unistd.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace varimarch
{

namespace
{

// Sends the standard error to a file for the lifetime of this object.
class RedirectedErrors
{
public:
  explicit RedirectedErrors(std::FILE* file)
  {
    std::fflush(stderr);
    dup2(fileno(file), STDERR_FILENO);
  }

  ~RedirectedErrors()
  {
    std::fflush(stderr);
    dup2(this->before, STDERR_FILENO);
    close(this->before);
  }

private:
  int before = dup(STDERR_FILENO);
};

}

std::string ErrorsDuring(const std::function<void()>& act)
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  if (!file)
  {
    throw std::runtime_error("Cannot make a temporary file for what the driver prints: look for "
                             "space in the folder of temporary files");
  }
  {
    const RedirectedErrors redirected(file.get());
    act();
  }
  std::fseek(file.get(), 0, SEEK_END);
  std::string text(std::size_t(std::ftell(file.get())), '\0');
  std::rewind(file.get());
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  return text;
}

}
