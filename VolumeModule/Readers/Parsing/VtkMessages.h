#ifndef Varimarch_Readers_Parsing_VtkMessages_h
#define Varimarch_Readers_Parsing_VtkMessages_h

#include "VarimarchVolumeModule.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

class vtkCallbackCommand;
class vtkObject;
class vtkOutputWindow;

namespace varimarch
{

/// A message of VTK.
struct VARIMARCHVOLUME_EXPORT VtkMessage
{
  enum class Kind
  {
    Error,
    Warning,
    Text, ///< neither; only VTK's output has such messages
  };
  Kind kind;
  std::string text; ///< VTK's own wording, "ERROR: In file, line 7\nvtkClass (0x1234): text\n\n"

  /// The text without file, line, class and address.
  std::string Sentence() const;
};

/// Catches messages of VTK that would otherwise be printed: errors and warnings of the objects that
/// it observes, and, after ObserveOutput, whatever VTK prints. The messages are kept, or passed on
/// to a handler.
class VARIMARCHVOLUME_EXPORT VtkMessages
{
public:
  using Handler = std::function<void(const VtkMessage&)>;

  VtkMessages();
  /// @param handler  receives each message at once, in the thread that reports it
  explicit VtkMessages(Handler handler);
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  void operator=(const VtkMessages&) = delete;

  /// Observes an object. Its messages after the end of this object are lost.
  void Observe(vtkObject* object);

  /// Replaces VTK's output until the end of this object. Where several do so, the last one receives
  /// the messages, and it must end first. VTK's log prints errors and warnings too, see vtkLogger.
  void ObserveOutput();

  /// The observer, for objects that pass it on to other objects.
  vtkCallbackCommand* Listener() { return this->listener; }

  /// All messages that were kept.
  const std::vector<VtkMessage>& All() const { return this->messages; }

  /// The sentences of the errors and warnings that were kept, each up to the end of its line.
  std::vector<std::string> Errors() const { return this->FirstLines(VtkMessage::Kind::Error); }
  std::vector<std::string> Warnings() const { return this->FirstLines(VtkMessage::Kind::Warning); }

  /// The sentence of the first message that was kept; empty: none.
  std::string FirstSentence() const
  {
    return this->messages.empty() ? "" : this->messages.front().Sentence();
  }

  /// The first error as part of a sentence, or `otherwise` if there is none.
  std::string FirstErrorOr(const std::string& otherwise) const;

private:
  std::vector<std::string> FirstLines(VtkMessage::Kind kind) const;

  Handler handler;
  vtkNew<vtkCallbackCommand> listener;
  vtkSmartPointer<vtkOutputWindow> outputBefore; ///< null: the output is not observed
  std::vector<VtkMessage> messages;
};

}

#endif
