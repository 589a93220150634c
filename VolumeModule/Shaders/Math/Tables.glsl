// Indices of tables that are linear between two entries.

// The index of a scalar, which need not be whole. The first and the last entry hold beyond them.
float TableIndex(float scalar, float scale, float bias, float lastIndex)
{
  return clamp(scalar * scale + bias, 0.0f, lastIndex);
}

// The entry below an index. There is always one above it too.
float EntryBelow(float index, float lastIndex)
{
  return floor(min(index, lastIndex - 1.0f));
}
