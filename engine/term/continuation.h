// Continuation-passing style, as in the paper's Haskell fragment (§3, after van Eijck and Unger 2010):
//
//   type Comp a r = (a -> r) -> r
//   cpsApply :: Comp (a -> b) r -> Comp a r -> Comp b r
//   cpsApply m n = \ k -> n (\ b -> m (\ a -> k (a b)))
//   cpsConst :: a -> Comp a r
//   cpsConst c = \ k -> k c
//
// A computation of an A takes the continuation, the rest of the work with it. It may run the continuation once, several
// times (one command for each of "those blocks") or never, or keep it for later (a command that lacks its argument).
#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace continua {

/// The rest of the work with an A; its answer is an R.
template <class A, class R>
using Continuation = std::function<R(A)>;

template <class A, class R>
using Comp = std::function<R(Continuation<A, R>)>;

/// The computation that only gives its value; the fragment's cpsConst.
template <class R, class A>
Comp<A, R> unit(A value) {
  return [value = std::move(value)](const Continuation<A, R>& k) { return k(value); };
}

/// Applies the function that `m` computes to the argument that `n` computes. `n` runs first, so its effects come first.
template <class A, class B, class R>
Comp<B, R> cpsApply(Comp<std::function<B(A)>, R> m, Comp<A, R> n) {
  // Captured values are shared: otherwise a copy of a continuation would copy all continuations behind it.
  const auto both = std::make_shared<const std::pair<decltype(m), decltype(n)>>(std::move(m), std::move(n));
  return [both](const Continuation<B, R>& next) {
    const auto k = std::make_shared<const Continuation<B, R>>(next);
    return both->second(
        [both, k](A b) { return both->first([k, b](const std::function<B(A)>& a) { return (*k)(a(b)); }); });
  };
}

}  // namespace continua
