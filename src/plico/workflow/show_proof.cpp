#include "plico/workflow/show_proof.h"

#include <fmt/format.h>

namespace plico {
namespace {

ProofStatus status_of(const PathProof& proof) {
  if (proof.interrupted) return ProofStatus::Unchecked;
  switch (proof.verdict) {
    case PathVerdict::Free:
      return ProofStatus::Proven;
    case PathVerdict::Collides:
      return ProofStatus::Collides;
    case PathVerdict::NotClosed:
    case PathVerdict::BeyondLimits:
    case PathVerdict::Undecided:
      break;
  }
  return ProofStatus::Undecided;
}

}  // namespace

void show_proof(ViewerInput& page, const ChainMotionVerdict& verdict) {
  page.proof = verdict.free()                             ? ProofStatus::Proven
               : verdict.verdict == PathVerdict::Collides ? ProofStatus::Collides
               : verdict.interrupted                      ? ProofStatus::Unchecked
                                                          : ProofStatus::Undecided;
  page.proof_note = fmt::format("{} distances of panels and piles, each good for as long as it lasts", verdict.steps);
  if (verdict.verdict == PathVerdict::Collides)
    page.collisions.push_back({verdict.from, verdict.to, verdict.panel_a, verdict.panel_b});
}

void show_proof(ViewerInput& page, const PathProof& proof) {
  page.proof = status_of(proof);
  if (proof.verdict == PathVerdict::Collides)
    page.collisions.push_back({proof.from, proof.to, proof.panel_a, proof.panel_b});
}

}  // namespace plico
