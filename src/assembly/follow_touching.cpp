// SPDX-License-Identifier: Apache-2.0
/// Update of the list of contributions if one more or one fewer body may touch.
#include "assembly/system.h"
#include "base/index.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace hawser::assembly {
namespace {

/// Compare two ascending lists. Return the index of the entry that `more` has in addition to
/// `less`; −1 if the lists differ in another way.
std::ptrdiff_t extra(std::span<const std::int32_t> more, std::span<const std::int32_t> less) {
    if (more.size() != less.size() + 1) return -1;
    const auto k = std::mismatch(less.begin(), less.end(), more.begin()).second - more.begin();
    return std::equal(less.begin() + k, less.end(), more.begin() + k + 1) ? k : -1;
}

}  // namespace

void System::list_skew_ops() {
    skew_ops_.clear();
    for (std::size_t i = 0; i < ops.size(); ++i)
        if (ops[i].kind == Op::contact) skew_ops_.push_back(static_cast<std::int32_t>(i));
}

/// Shift the ranges of matrix contributions (ops) of all pieces after the ops from `from` on have
/// moved by `by`. An inserted op belongs to the piece of the op before it.
void System::shift_pieces(std::int64_t from, std::int64_t by) noexcept {
    for (auto* ranges : {&piece_ops_, &step_ops_})
        for (OpRange& r : *ranges) {
            if (r.op_begin >= from) r.op_begin += by;
            if (r.op_end >= from) r.op_end += by;
        }
}

/// Add the diagonal contact block of a body whose column is in an ordinary front. Its op is
/// inserted behind the ops of interactions in this column and before the ops of links.
void System::add_own_block(std::int32_t block, std::int32_t node) {
    const std::int64_t place = symbolic.column_address(symbolic.position[at(node)]);
    const std::int32_t body = member_of_node_[at(node)];
    const int dof = dof_[at(body)];
    const factor::BlockTarget t = symbolic.target(node, node);
    Op op{};
    OpParts{block, Op::contact, 0, 0, 0, 0, dof, dof, 0}.write(op, t.address, t.step, t.ld);
    const auto end = std::upper_bound(op_slot_.begin(), op_slot_.end(), place);
    auto k = at(std::lower_bound(op_slot_.begin(), end, place) - op_slot_.begin());
    while (k < at(end - op_slot_.begin()) && ops[k].kind != Op::contact) ++k;
    ops.insert(ops.begin() + static_cast<std::ptrdiff_t>(k), op);
    op_slot_.insert(op_slot_.begin() + static_cast<std::ptrdiff_t>(k), place);
    shift_pieces(static_cast<std::int64_t>(k), 1);
}

void System::drop_block(std::int32_t block) {
    const auto found = std::find_if(ops.begin(), ops.end(), [&](const Op& op) {
        return op.kind == Op::contact && op.id == block;
    });
    if (found == ops.end()) return;  // the body sleeps
    const auto k = found - ops.begin();
    ops.erase(found);
    op_slot_.erase(op_slot_.begin() + k);
    shift_pieces(k + 1, -1);
}

void System::follow_touching(const model::Bodies& bodies, const model::Interactions& in) {
    const std::span<const std::int32_t> now = contacts.touching(),
                                        before = contacts.touching_before();
    const std::ptrdiff_t came = extra(now, before), went = extra(before, now);
    const std::int32_t body = came >= 0 ? now[at(came)] : went >= 0 ? before[at(went)] : -1;
    const std::int32_t node = body < 0 ? -1 : node_of_body[at(body)];
    // Lanes of a batch share their contributions.
    if (body < 0 || (node >= 0 && symbolic.fronts[at(symbolic.node_front[at(node)])].batch >= 0)) {
        build_ops(bodies, in);
        return;
    }
    // Blocks are numbered by the bodies that may touch.
    const auto block = static_cast<std::int32_t>(came >= 0 ? came : went);
    history_.forget();
    if (went >= 0) drop_block(block);
    for (Op& op : ops)
        if (op.kind == Op::contact && (came >= 0 ? op.id >= block : op.id > block))
            op.id += came >= 0 ? 1 : -1;
    if (came >= 0 && node >= 0) add_own_block(block, node);
    list_skew_ops();
    history_.renumber_blocks(contacts.blocks);
}

}  // namespace hawser::assembly
