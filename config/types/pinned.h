// Bases of what may be neither copied nor moved. Threads: none of their own.
#pragma once

namespace touchline {

/// A base of classes that stay where they are, because others point to them or because they own
/// what exists once.
class Pinned {
  public:
    Pinned(const Pinned&) = delete;
    Pinned& operator=(const Pinned&) = delete;

  protected:
    Pinned() = default;
    ~Pinned() = default;
};

/// A base of classes of which only the functions are known, and that are deleted through it.
class Interface : public Pinned {
  public:
    virtual ~Interface() = default;

  protected:
    Interface() = default;
};

}  // namespace touchline
