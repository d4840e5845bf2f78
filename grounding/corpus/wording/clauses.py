"""Productions of relative clauses, and of the adjectives in them."""

TEXT = """
[that.word]
that 8 : (WHNP that/WDT)
which 2 : (WHNP which)

[is]
is 8 : is
s 2 : 's/VBZ

[that]
where 12 @deep : (SBAR <that.word> (S (VP <is> <where>)))
where.brief 4 : (SBAR <that.word> (S (VP <is> <location>)))
closest 5 : (SBAR <that.word> (S (VP <is> <closest.pp>)))
the.closest 3 @viewer : (SBAR <that.word> (S (VP <is> (NP (NP the <near> one/NN) (PP to <person>)))))
the.closest.pp 3 @viewer : (SBAR <that.word> (S (VP <is> (NP (NP the closest|nearest) (PP to <person>)))))
the.farthest 3 @viewer : (SBAR <that.word> (S (VP <is> (NP (NP the farthest|furthest away/RB) (PP from <person>)))))
the.furthest.side 1 : (SBAR <that.word> (S (VP <is> (NP (NP the furthest|farthest) (PP to|on <side.np>)))))
the.ranked 1 : (SBAR <that.word> (S (VP <is> (NP the <rank>))))
the.ordinal.from 0.7 : (SBAR <that.word> (S (VP <is> (NP (NP the <ordinal>) <from.side>))))
the.one 0.7 @deep : (SBAR <that.word> (S (VP <is> (NP (NP the <rank> one/NN) <where>))))
both 1.2 @deep : (SBAR <that.word> (S (VP <is> (PP <where> and <where>))))
but 0.7 @deep : (SBAR <that.word> (S (VP <is> (PP <where> but <where>))))
and.is 0.6 @deep : (SBAR <that.word> (S (VP (VP <is> <where>) and (VP is <where>))))
adjective 2 : (SBAR <that.word> (S (VP <is> <adjective>)))
lone.and 0.4 @deep : (SBAR <that.word> (S (VP <is> <adjective> and <where>)))
not 1 @deep : (SBAR <that.word> (S (VP <is> not/RB <where>)))
is.adverb 1 @deep : (SBAR <that.word> (S (VP <is> also|still|now|just|completely/RB <where>)))
has 2 @deep : (SBAR <that.word> (S (VP has <reference> <where>)))
has.simply 0.7 @deep : (SBAR <that.word> (S (VP has <reference>)))
touches 1 @deep : (SBAR <that.word> (S (VP touches <reference>)))
stands 1.2 @deep : (SBAR <that.word> (S (VP sits|lies|stands <where>)))
not.there 1 @loose : (SBAR (WHNP that/WDT) <closest.pp>)
you.see 0.5 @viewer : (SBAR (S (NP you) (VP see <location>)))
that.you.see 0.3 @viewer : (SBAR <that.word> (S (NP you) (VP see <location>)))
moved 0.5 @history : (SBAR (S (NP you) (VP <just.moved>)))
that.moved 0.4 @history : (SBAR <that.word> (S (NP you) (VP <just.moved>)))
you.can.see 0.3 @viewer : (SBAR (S (NP you) (VP can (VP see/VB <location>))))

[that.set]
where 4 @deep : (SBAR <that.word> (S (VP <is> <where>)))
has 2 : (SBAR <that.word> (S (VP has (NP <number> <nouns>))))
made 1 : (SBAR <that.word> (S (VP <is> (VP made|formed (PP of (NP <number> <nouns>))))))

[that.are]
where 6 @deep : (SBAR <that.word> (S (VP are <where>)))
where.brief 3 : (SBAR <that.word> (S (VP are <location>)))
touching 1 : (SBAR <that.word> (S (VP are (PP touching (NP each other/JJ)))))
closest 2 : (SBAR <that.word> (S (VP are <closest.pp>)))
in.line 2 @arrangement : (SBAR <that.word> (S (VP are <in.formation>)))
together 0.7 : (SBAR <that.word> (S (VP are (ADJP close|right/JJ together))))
form 0.7 @arrangement : (SBAR <that.word> (S (VP form/VBP (NP a row|line|column|diagonal/NN|circle))))

[adjective]
alone 4 : (ADJP alone|isolated|separate|lone)
color 1 @color : (ADJP <color>)
nearer 1 : (ADJP closer|farther|further)
away 2 : (ADJP closest|farthest|furthest away/RB)
extreme 1 : (ADJP closest|nearest|farthest|furthest|leftmost|rightmost|highest|lowest)
all.alone 0.5 : (ADJP all/RB alone)
nth 0.5 : (ADJP second|third closest|farthest|furthest)
"""
