#pragma once

// Private to linalg/: PETSc's types do not leave this folder.

#include <petscksp.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace blockfsi::linalg::petsc
{

/// Throws if a PETSc call failed: a mistake of ours, not of the user.
inline void check(PetscErrorCode code)
{
  if (code != 0)
    throw std::runtime_error("PETSc reported error " + std::to_string(code));
}

/// Owner of one PETSc object.
template <class T, PetscErrorCode (*Destroy)(T*)>
class Handle
{
public:
  Handle() = default;
  Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept
  {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Handle()
  {
    if (object_ != nullptr)
      Destroy(&object_);
  }

  operator T() const { return object_; }
  T* address() { return &object_; }

private:
  T object_ = nullptr;
};

using Matrix = Handle<Mat, MatDestroy>;
using Vector = Handle<Vec, VecDestroy>;
using Solver = Handle<KSP, KSPDestroy>;

}  // namespace blockfsi::linalg::petsc
