import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from grounding.geometry.arrangement import Arrangement
from grounding.geometry.prominence import evident, prominent

formed = st.builds(
    Arrangement,
    st.sampled_from(["row", "column", "group", "circle", "tower"]),
    st.integers(3, 2**10 - 1),
    st.integers(2, 9),
    st.just(np.zeros(3)),
    st.floats(0, 1),
    st.floats(0, 1),
    st.floats(0, 5),
    st.floats(0, 0.7),
)


@given(st.lists(formed, max_size=12))
def test_what_is_kept_shares_no_members_and_nothing_better_is_left_out(arrangements: list[Arrangement]) -> None:
    kept = prominent(arrangements)
    assert list(kept) == sorted(kept, key=lambda a: (-a.prominence, a.kind, a.mask))
    for place, one in enumerate(kept):
        assert one.prominence > 0
        assert not any(one.kind == other.kind and one.mask & other.mask for other in kept[:place])
    for one in arrangements:
        if one.prominence > 0 and all(one is not other for other in kept):
            rivals = [other for other in kept if other.kind == one.kind and other.mask & one.mask]
            assert max(other.prominence for other in rivals) >= one.prominence


@given(st.lists(formed, max_size=12))
def test_only_what_is_evident_by_itself_is_evident_beside_others(arrangements: list[Arrangement]) -> None:
    assert evident(arrangements) <= {(a.kind, a.mask) for a in arrangements if a.evident}
