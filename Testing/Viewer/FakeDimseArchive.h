#ifndef Varimarch_Testing_FakeDimseArchive_h
#define Varimarch_Testing_FakeDimseArchive_h

#include <QByteArray>
#include <QMap>
#include <QTcpServer>
#include <QTcpSocket>
#include <QtEndian>

/// A server of DIMSE on this computer that answers the first search of an association by one entry
/// (PS3.7 9.1.2, PS3.8 9.3).
class FakeDimseArchive : public QTcpServer
{
public:
  /// @param entry  attributes of the entry, in implicit little endian
  explicit FakeDimseArchive(const QByteArray& entry)
    : entry(entry)
  {
    this->listen(QHostAddress::LocalHost);
    connect(this, &QTcpServer::newConnection, this,
      [this]
      {
        QTcpSocket* const socket = this->nextPendingConnection();
        connect(socket, &QTcpSocket::readyRead, this, [this, socket] { this->Read(socket); });
      });
  }

  QString Url() const
  {
    return QStringLiteral("dicom://FAKE@127.0.0.1:%1").arg(this->serverPort());
  }

  /// An attribute in implicit little endian.
  static QByteArray Attribute(quint16 group, quint16 element, QByteArray value)
  {
    value.append(value.size() % 2, ' ');
    return Number(qToLittleEndian(group)) + Number(qToLittleEndian(element)) +
      Number(qToLittleEndian(quint32(value.size()))) + value;
  }

private:
  static constexpr const char* FindClass = "1.2.840.10008.5.1.4.1.2.2.1";

  template <class Integer>
  static QByteArray Number(Integer value)
  {
    return { reinterpret_cast<const char*>(&value), sizeof(value) };
  }

  static QByteArray Message(char kind, const QByteArray& content)
  {
    return QByteArray(1, kind) + '\0' + Number(qToBigEndian(quint32(content.size()))) + content;
  }

  static QByteArray Item(char kind, const QByteArray& content)
  {
    return QByteArray(1, kind) + '\0' + Number(qToBigEndian(quint16(content.size()))) + content;
  }

  static QByteArray Acceptance()
  {
    const QByteArray context =
      Item(0x21, QByteArray("\1\0\0\0", 4) + Item(0x40, "1.2.840.10008.1.2"));
    const QByteArray user = Item(0x50, Item(0x51, QByteArray("\0\0\x40\0", 4)) + Item(0x52, "1.2"));
    return Message(2,
      QByteArray("\0\1\0\0", 4) + QByteArray("FAKE").leftJustified(16) +
        QByteArray("VARIMARCH").leftJustified(16) + QByteArray(32, '\0') +
        Item(0x10, "1.2.840.10008.3.1.1.1") + context + user);
  }

  // A part of a message: a command, or data.
  static QByteArray Part(char flags, const QByteArray& content)
  {
    return Message(4, Number(qToBigEndian(quint32(content.size() + 2))) + '\1' + flags + content);
  }

  static QByteArray Answer(bool hasData)
  {
    const auto number = [](quint16 element, quint16 value)
    { return Attribute(0, element, Number(qToLittleEndian(value))); };
    const QByteArray rest = Attribute(0, 0x0002, QByteArray(FindClass) + '\0') +
      number(0x0100, 0x8020) + number(0x0120, 1) + number(0x0800, hasData ? 0 : 0x0101) +
      number(0x0900, hasData ? 0xff00 : 0);
    return Part(3, Attribute(0, 0, Number(qToLittleEndian(quint32(rest.size())))) + rest);
  }

  void Read(QTcpSocket* socket)
  {
    const QByteArray all = socket->readAll();
    if (all[0] == 1)
    {
      socket->write(Acceptance());
    }
    else if (all.contains(FindClass))
    {
      socket->write(Answer(true) + Part(2, this->entry) + Answer(false));
    }
    if (all.contains(QByteArray("\5\0\0\0\0\4", 6)))
    {
      socket->write(Message(6, QByteArray(4, '\0')));
    }
  }

  QByteArray entry;
};

#endif
