#ifndef Varimarch_Scene_Fields_h
#define Varimarch_Scene_Fields_h

#include "Scene/Json/JsonForm.h"

#include <algorithm>
#include <deque>

namespace varimarch
{

/// The words about a field, from which documents, help and schema are made.
struct FieldText
{
  const char* meaning = ""; ///< a phrase without unit and default; empty: not in documents
  const char* unit = "";
  const char* usual = nullptr; ///< the default in words; null: the value of a new struct
  const char* details = "";    ///< goes on after the meaning, in documents only
};

/// A field of a struct. The functions that return a reference refine it.
template <class Struct>
struct Field
{
  std::string key;
  FieldText text;
  std::function<void(const JsonCursor& object, Struct&)> read = {};
  /// Empty: the field is left out.
  std::function<std::optional<nlohmann::ordered_json>(const Struct&)> write = {};
  std::function<nlohmann::ordered_json(FormatDescription&)> describe = {};
  std::function<bool(const Struct&)> isAllowed = {}; ///< empty: for all values of fields before it
  bool isRequired = false;
  std::string option = {};
  std::string optionValue = {};
  bool isArgument = false;

  Field& Required()
  {
    this->isRequired = true;
    return *this;
  }

  /// Has the command line change the field, by an option such as "--zoom".
  Field& Option(const std::string& name, const std::string& value = {})
  {
    this->option = name;
    this->optionValue = value;
    return *this;
  }

  /// Has Python's render() offer the option too, as an argument of this name.
  Field& Argument()
  {
    this->isArgument = true;
    return *this;
  }

  /// Leaves the field out of files where this holds.
  Field& OmitIf(const std::function<bool(const Struct&)>& isOmitted)
  {
    this->write = [isOmitted, before = this->write](const Struct& object)
    { return isOmitted(object) ? std::nullopt : before(object); };
    return *this;
  }

  /// Leaves the field out of files where it has its default.
  Field& OmitDefault()
  {
    this->write = [before = this->write, usual = this->write(Struct{})](const Struct& object)
    {
      auto json = before(object);
      return json == usual ? std::nullopt : json;
    };
    return *this;
  }

  /// Makes the key unknown where this does not hold, by the values of the fields before it.
  Field& OnlyIf(const std::function<bool(const Struct&)>& isAllowedNow)
  {
    this->isAllowed = isAllowedNow;
    return *this;
  }
};

/// The fields of a struct as a JSON object, in the order in which files have them. This list is the
/// only place that knows the keys: reader, writer, hints, schema, tables of the documentation and
/// options of the command line are made from it.
template <class Struct>
class Fields
{
public:
  explicit Fields(const std::string& name)
    : name(name)
  {
  }

  /// @param add  adds the fields to the new list
  Fields(const std::string& name, void (*add)(Fields& list))
    : name(name)
  {
    add(*this);
  }

  template <class Value>
  Field<Struct>& Add(const std::string& key, Value Struct::*member, const JsonForm<Value>& form,
    const FieldText& text)
  {
    return this->AddField(
      key, text, form.describe,
      [=](const JsonCursor& json, Struct& object) { form.read(json, object.*member); },
      [=](const Struct& object) { return std::optional(form.write(object.*member)); });
  }

  /// A field that is left out where it is empty.
  template <class Value>
  Field<Struct>& Add(const std::string& key, std::optional<Value> Struct::*member,
    const JsonForm<Value>& form, const FieldText& text)
  {
    return this->AddField(
      key, text, form.describe,
      [=](const JsonCursor& json, Struct& object)
      { form.read(json, (object.*member).emplace(Value{})); },
      [=](const Struct& object)
      { return object.*member ? std::optional(form.write(*(object.*member))) : std::nullopt; });
  }

  /// A field that an object must have.
  template <class Member, class Value>
  Field<Struct>& Require(const std::string& key, Member Struct::*member,
    const JsonForm<Value>& form, const FieldText& text)
  {
    return this->Add(key, member, form, text).Required();
  }

  /// A field that is no member.
  /// @param read  reads the value of the key
  Field<Struct>& AddField(const std::string& key, const FieldText& text,
    const std::function<nlohmann::ordered_json(FormatDescription&)>& describe,
    const std::function<void(const JsonCursor&, Struct&)>& read,
    const std::function<std::optional<nlohmann::ordered_json>(const Struct&)>& write)
  {
    Field<Struct>& field = this->fields.emplace_back(Field<Struct>{ key, text });
    field.read = read;
    field.write = write;
    field.describe = describe;
    return field;
  }

  /// Adds all fields of a member as fields of this struct.
  template <class Member>
  void AddAllOf(Member Struct::*member, const Fields<Member>& others)
  {
    for (const Field<Member>& other : others.All())
    {
      Field<Struct>& field = this->AddField(
        other.key, other.text, other.describe,
        [=](const JsonCursor& json, Struct& object) { other.read(json, object.*member); },
        [=](const Struct& object) { return other.write(object.*member); });
      field.isRequired = other.isRequired;
      field.option = other.option;
      field.optionValue = other.optionValue;
      field.isArgument = other.isArgument;
    }
    for (const auto& check : others.Checks())
    {
      this->checks.push_back(
        [=](const JsonCursor& json, const Struct& object) { check(json, object.*member); });
    }
  }

  using Check = std::function<void(const JsonCursor&, const Struct&)>;

  /// Adds a check of fields together, which throws.
  void AddCheck(const Check& check) { this->checks.push_back(check); }

  /// Reads the keys that an object has, and keeps the others. Requires an object without other
  /// keys, with all that are required.
  void Read(const JsonCursor& json, Struct& object) const
  {
    // The fields that are allowed follow from the first one.
    const bool hasKinds = std::any_of(this->fields.begin(), this->fields.end(),
      [](const Field<Struct>& field) { return bool(field.isAllowed); });
    if (hasKinds)
    {
      this->fields.front().read(json.At(this->fields.front().key), object);
    }
    json.RequireObject(this->KeysOf(object));
    for (const Field<Struct>& field : this->fields)
    {
      if (field.isAllowed && !field.isAllowed(object))
      {
        continue;
      }
      const auto found =
        field.isRequired ? std::optional(json.At(field.key)) : json.Find(field.key);
      if (found)
      {
        field.read(*found, object);
      }
    }
    for (const Check& check : this->checks)
    {
      check(json, object);
    }
  }

  nlohmann::ordered_json Write(const Struct& object) const
  {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const Field<Struct>& field : this->fields)
    {
      if (field.isAllowed && !field.isAllowed(object))
      {
        continue;
      }
      if (auto value = field.write(object))
      {
        json[field.key] = std::move(*value);
      }
    }
    return json;
  }

  nlohmann::ordered_json Describe(FormatDescription& format) const
  {
    if (!format.HasStruct(this->name))
    {
      format.Add(this->name);
      for (const Field<Struct>& field : this->fields)
      {
        const nlohmann::ordered_json schema = field.describe(format);
        format.At(this->name)
          .fields.push_back({ field.key, field.text.meaning, field.text.unit, UsualOf(field),
            field.text.details, field.isRequired && !field.isAllowed, field.option,
            field.optionValue, field.isArgument, schema });
      }
    }
    return SchemaOfReference(this->name);
  }

  /// The keys of all values of the struct.
  std::vector<std::string> Keys() const
  {
    std::vector<std::string> keys;
    for (const Field<Struct>& field : this->fields)
    {
      keys.push_back(field.key);
    }
    return keys;
  }

  const std::deque<Field<Struct>>& All() const { return this->fields; }
  const std::vector<Check>& Checks() const { return this->checks; }

private:
  std::vector<std::string> KeysOf(const Struct& object) const
  {
    std::vector<std::string> keys;
    for (const Field<Struct>& field : this->fields)
    {
      if (!field.isAllowed || field.isAllowed(object))
      {
        keys.push_back(field.key);
      }
    }
    return keys;
  }

  static std::string UsualOf(const Field<Struct>& field)
  {
    if (field.text.usual || field.isRequired)
    {
      return field.text.usual ? field.text.usual : "";
    }
    const auto json = field.write(Struct{});
    return json ? UsualText(*json) : "none";
  }

  std::string name;
  std::deque<Field<Struct>> fields;
  std::vector<Check> checks;
};

/// The form of a struct, given the function that returns its fields.
template <class Struct>
JsonForm<Struct> ObjectForm(const Fields<Struct>& (*fields)())
{
  return { [=](const JsonCursor& json, Struct& object) { fields().Read(json, object); },
    [=](const Struct& object) { return fields().Write(object); },
    [=](FormatDescription& format) { return fields().Describe(format); } };
}

}

#endif
