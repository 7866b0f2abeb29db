-- The weaver: a pandoc filter that puts what the build found in place of the directives in paper/*.md, for LaTeX and for
-- the web. What cannot be found stops it, with file and line.
--
--     sed 's/<</`&/g; s/>>/&`/g' CHAPTER.md | pandoc -f markdown-implicit_figures -L paper/weave.lua -t latex|html
--
-- From the environment: CT_PROGRAM, CT_DATA, CT_BUILD; CT_DATE, the day of the source; CT_PAGE, the page that is made.
-- A line by itself:
--   <<equation ID [only NAME ...]>>   the formula from the sheet as parsed, under its number
--   <<equation ID = TEX>>             the same for a section of the sheet that has no formula
--   <<printed ID [only NAME ...]>>    what the paper has instead, and why it cannot be
--   <<function ID>>                   the function of ref/ that carries the equation's number;  <<helper NAME>>  another one
--   <<step ID>>                       a derivation step, its algebra, where it holds, and what is dropped
--   <<verdict ID>>                    a verdict;  <<findings VERDICT>>  a table of those that have it, and why
--   <<run ARGUMENT ...>>              a command of the program, and what it prints
--   <<gains N ... C1,C2>>             a table of what `coulomb-tether design` finds for these gains, in units of the orbit
--   <<symbols>>, <<index>>            the quantities of the sheet; the index of equations
--   <<places>>, <<verdicts>>          for the web: each equation with all that belongs to it; all verdicts
-- Within a line, in mathematics too:
--   <<number FILE ROW COLUMN DIGITS [SCALE]>>   from data/FILE or build/FILE, the row by its first column, or columns: A,B
--   <<value NAME DIGITS ARGUMENT ...>>          what a command of the program finds
--   <<quote ID before|text|after>>    `text`, provided that the evidence of a verdict reads so
--   <<count WHAT>>                    steps, vectors, inputs, misprints, verdicts, or one kind of verdict
-- ![CAPTION](plot:NAME) is a plot of data/, ![CAPTION](graph:CHAPTER) what that chapter's steps lead from and to;
-- [(7)](#eq:7), [section](#ID), [Figure](#fig:NAME) and [](#ref:NAME) have to lead somewhere.

local web = FORMAT:match 'html' ~= nil
-- A word of the shell: a folder may have any name.
local function word(text) return "'" .. text:gsub("'", "'\\''") .. "'" end

local program, data, build = word(os.getenv 'CT_PROGRAM' or ''), os.getenv 'CT_DATA', os.getenv 'CT_BUILD'
local current = ''  -- what is being woven, as it stands in the source

---- reading ----

local function read(path)
  local file = io.open(path)
  local text = file and file:read 'a'
  if file then file:close() end
  return text
end

local function output_of(command)
  local pipe = io.popen(command)
  local text = pipe:read 'a'
  return pipe:close() and text or nil
end

local chapters, sources = {}, {}
for path in output_of 'ls paper/*.md':gmatch '%S+' do
  sources[#sources + 1] = path
  if path:match 'paper/%d' then chapters[#chapters + 1] = path end
end

local function stop(text, ...)
  local where = current
  for _, path in ipairs(os.getenv 'CT_PROSE' and {os.getenv 'CT_PROSE'} or sources) do
    local number = 0
    for line in io.lines(path) do
      number = number + 1
      if where == current and line:find(current, 1, true) then where = path .. ':' .. number end
    end
  end
  io.stderr:write(where, ': ', text:format(...), '\n')
  os.exit(1)
end

local function made(path) return read(build .. '/' .. path) or error('no ' .. build .. '/' .. path .. ': run make check') end

local function words_of(text)
  local words = {}
  for part in (text or ''):gmatch '%S+' do words[#words + 1] = part end
  return words
end

-- JSON is Lua but for brackets and colons; its strings are kept aside meanwhile. Entries can be found by their id.
local function entries_of(path)
  local strings = {}
  local text = made(path):gsub('\\(.)', {['"'] = '\1', ['\\'] = '\2', n = '\n'})
  text = text:gsub('"([^"]*)"', function(string)
    strings[#strings + 1] = string:gsub('\1', '"'):gsub('\2', '\\')
    return '"' .. #strings .. '"'
  end)
  text = text:gsub('%[', '{'):gsub('%]', '}'):gsub('"(%d+)": ', '[strings[%1]] = '):gsub('"(%d+)"', 'strings[%1]')
  local all = load('local strings = ... return ' .. text)(strings)
  local list = all.derivations and all.derivations.steps or all.claims or all.errors
  for _, entry in ipairs(list) do list[entry.id] = entry end
  return list
end

-- The rows of a CSV file by its columns' names; no field of ours has a quotation mark or a line break in it.
local function rows_of(text)
  local rows, heads = {}, nil
  for line in text:gmatch '[^\n]+' do
    local row, i = {line = line}, 0
    local plain = line:gsub('"([^"]*)"', function(quoted) return (quoted:gsub(',', '\0')) end)
    for field in (plain .. ','):gmatch '([^,]*),' do
      i = i + 1
      row[heads and heads[i] or i] = field:gsub('%z', ',')
    end
    if heads then rows[#rows + 1] = row else heads = row end
  end
  return rows, heads
end

local steps, verdicts, errors = entries_of 'derivations.json', entries_of 'claims.json', entries_of 'errors.json'
local gate = rows_of(made 'gate.csv')
for _, row in ipairs(gate) do gate[row.id] = row end

-- The sheet as `coulomb-tether typeset` prints it: ID, KIND, NUMBER, NAME, TEX by tabs.
local sections, symbol, tex_of = {}, {}, {}
for line in output_of(program .. ' typeset'):gmatch '[^\n]+' do
  local id, kind, number, name, tex = line:match '^([^\t]*)\t([^\t]*)\t([^\t]*)\t([^\t]*)\t(.*)$'
  if kind == 'symbol' then
    tex_of[name] = tex
    if #name > 1 then symbol[name] = tex end  -- a letter by itself may be any word
  else
    local s = sections[id] or {id = id, numbers = {}, rows = {}}
    if not sections[id] then sections[id], sections[#sections + 1] = s, s end
    if kind == 'number' then s.numbers[#s.numbers + 1] = number
    elseif kind == 'title' or kind == 'note' or kind == 'reason' then s[kind] = tex
    else s.rows[#s.rows + 1] = {kind = kind, number = number, name = name, tex = tex} end
  end
end
symbol.stable = nil  -- a word in prose that happens to be a quantity
for name in ('pi lambda mu phi kappa epsilon rho omega cos sin tan'):gmatch '%a+' do symbol[name] = '\\' .. name .. ' ' end

-- {6a, 6b, 7}: 6a, 6, 6b, 7, each once.
local function names_of(s)
  local names = {}
  for _, number in ipairs(s.numbers) do
    for _, name in ipairs {number, (number:gsub('%a$', ''))} do
      if not names[name] then names[name], names[#names + 1] = true, name end
    end
  end
  return names
end

-- Which section has a number: of several the first, which is named for it alone.
local section_of = {}
for _, s in ipairs(sections) do
  for _, name in ipairs(names_of(s)) do section_of[name] = section_of[name] or s.id end
end

local functions = {}
for path in output_of 'ls ref/*.c':gmatch '%S+' do
  for text, name in ('\n' .. read(path):gsub('\n', '\n\n')):gmatch '\n(%a[^\n;]-([%w_]+)%([^;{}]-%)\n\n{\n.-\n}\n)' do
    functions[name] = {path = path, text = text:gsub('\n\n', '\n')}
  end
end

---- labels: sections, figures and references, in the order of the chapters ----

local labels, pages, page_of_step = {}, {}, {}
do
  local number, letters, cited = 0, 0, 0
  for _, path in ipairs(chapters) do
    local page, text = path:match '([^/]*)%.md$' .. '.html', read(path)
    for hashes, title, id, rest in ('\n' .. text):gmatch '\n(#+) ([^\n]-) {#(%S+)([^}\n]*)}' do
      if hashes == '#' and rest == '' then number = number + 1 end
      labels[id] = {text = rest == '' and tostring(number) or title, page = page}
      if hashes == '#' then pages[#pages + 1] = {file = page, title = title, number = rest == '' and tostring(number) or ''} end
    end
    for kind, name in text:gmatch '%]%((%a+):([%w-]+)%)' do
      if kind == 'plot' or kind == 'graph' then
        local ours = not name:match '^%d%a?$'
        if ours then letters = letters + 1 end
        labels['fig:' .. (kind == 'graph' and 'graph-' or '') .. name] = {text = ours and string.char(64 + letters) or name, page = page}
      end
    end
    for id in text:gmatch '{#(ref:%w+)}' do
      cited = cited + 1
      labels[id] = {text = '[' .. cited .. ']', page = page}
    end
    for id in text:gmatch '\n<<step ([%w_]+)>>' do page_of_step[id] = page end
    for id, tex in text:gmatch '\n<<equation (%w+) = ([^\n]*)>>' do (sections[id] or {}).defined = tex end
  end
end

local function link(el)
  local id = el.target:match '^#(.*)$'
  if not id then return nil end
  current = '](' .. el.target .. ')'
  local number = id:match '^eq:(.*)$'
  if number then
    if not section_of[number] then stop("unknown equation '%s', expected a number of the paper", number) end
    return web and pandoc.Link(el.content, 'equations.html#' .. id) or pandoc.RawInline('latex', '\\eq{' .. number .. '}')
  end
  if web and sections[id] then return nil end  -- an equation's own place
  local label = labels[id] or stop("unknown reference '%s', expected a section, figure or reference", id)
  local content = el.content:clone()
  content:insert(pandoc.Str((#el.content > 0 and '\u{a0}' or '') .. label.text))
  if web then return pandoc.Link(content, label.page .. '#' .. id) end
  return {pandoc.RawInline('latex', '\\hyperref[' .. id .. ']{'), pandoc.Span(content), pandoc.RawInline('latex', '}')}
end

---- plain text as TeX, and TeX as pandoc has it ----

local sign = {['<='] = '$\\le $', ['>='] = '$\\ge $', ['<<'] = '$\\ll $', ['->'] = '$\\to $', ['+-'] = '$\\pm $', ['-+'] = '$\\mp $',
              ['*'] = '$\\cdot $', ['...'] = '\\dots{}', ['<'] = '$<$', ['>'] = '$>$', ['\\'] = '\\textbackslash{}',
              ['^'] = '\\^{}', ['~'] = '\\textasciitilde{}'}

local function escape(text) return (text:gsub('[\\^~]', sign):gsub('[#$%%&_]', '\\%0')) end

local function scientific(digits, exponent)
  exponent = math.tointeger(tonumber(exponent))
  return digits .. (exponent ~= 0 and '\\times 10^{' .. exponent .. '}' or '')
end

-- A text of the sheet or of a step, without marks: its symbols, its signs and powers that are numbers become mathematics.
local function prose(text)
  local out = {}
  while text ~= '' do
    local token = text:match '^[%d.]+e[-+]?%d+' or text:match '^%a[%w_]*' or text:match '^%^%-?%d+'
                  or sign[text:sub(1, 3)] and text:sub(1, 3) or sign[text:sub(1, 2)] and text:sub(1, 2) or text:sub(1, 1)
    local digits, exponent = token:match '^([%d.]+)e(.+)$'
    out[#out + 1] = digits and '$' .. scientific(digits, exponent) .. '$' or symbol[token] and '$' .. symbol[token] .. '$'
                    or token:match '^%^.' and '$^{' .. token:sub(2) .. '}$' or sign[token] or escape(token)
    text = text:sub(#token + 1)
  end
  return (table.concat(out):gsub('%$%$', ''))
end

local function capital(text) return text:sub(1, 1):upper() .. text:sub(2) end

-- So many significant digits, with a power of ten where the number is far from one.
local function decimal(value, digits)
  local mantissa, exponent = ('%%.%de'):format(digits - 1):format(value):match '^(.*)e(.*)$'
  exponent = tonumber(exponent)
  if tonumber(value) ~= 0 and (exponent < -3 or exponent > 5) then return scientific(mantissa, exponent) end
  return ('%%.%df'):format(math.max(digits - 1 - exponent, 0)):format(value)
end

-- In MathML upright letters are text, or each would be one of its own; and a product has its space anyway.
local function upright(tex) return web and tex:gsub('\\mathrm(%b{})', '{\\text%1}'):gsub('\\,', ' ') or tex end

-- TeX of the build as inlines: for LaTeX as it is, for the web as pandoc reads it.
local function inlines(tex)
  if not web then return {pandoc.RawInline('latex', tex)} end
  tex = upright(tex:gsub('\\textmu ?', 'µ'):gsub('%$([%d.<>]+)%$', '%1'))
  local block = pandoc.read('\\newcommand{\\eq}[1]{\\href{\\#eq:#1}{(#1)}}\n' .. tex, 'latex').blocks[1]
  return block and pandoc.walk_block(block, {Link = link}).content or {}
end

local function raw(text) return pandoc.RawBlock(web and 'html' or 'latex', text) end

-- Inlines, or blocks, one after the other.
local function join(...)
  local all = pandoc.List()
  for _, part in ipairs {...} do all:extend(type(part) == 'string' and {pandoc.Str(part)} or part) end
  return all
end
local function para(...) return pandoc.Para(join(...)) end

-- Blocks of a class: what LaTeX calls an environment.
local function box(class, blocks, id)
  if web then return {pandoc.Div(blocks, {id = id or '', class = class})} end
  return join({raw('\\begin{' .. class:match '%a+' .. '}')}, blocks, {raw('\\end{' .. class:match '%a+' .. '}')})
end

-- What a reader opens on demand.
local function details(summary, blocks)
  return join({raw('<details><summary>' .. summary .. '</summary>')}, blocks, {raw '</details>'})
end

local function table_of(heads, widths, rows)
  local aligned, head = {}, {}
  for i, text in ipairs(heads) do aligned[i], head[i] = 'AlignDefault', {pandoc.Plain(text)} end
  for _, row in ipairs(rows) do
    for i, cell in ipairs(row) do row[i] = {pandoc.Plain(cell)} end
  end
  return pandoc.utils.from_simple_table(pandoc.SimpleTable({}, aligned, widths, head, rows))
end

---- equations ----

local qualifier = {lin = 'small angles', inv = 'inverse', exact = 'exact', roots = 'roots', flow = 'flow', rk4 = 'Runge-Kutta'}
local function qualified(id) return qualifier[id:match '^eq%d+(.*)$' or id:match '^%a+%d?'] end

-- {2a, 2b, 2c} as the reader sees it: 2a to 2c.
local function span_of(list) return #list < 2 and list[1] or list[1] .. (#list == 2 and ', ' or '–') .. list[#list] end

local function section(id) return sections[id] or stop("unknown equation '%s', expected a section of paper/equations.yaml", id) end

local function only_names(words)
  if not words[3] then return nil end
  if words[3] ~= 'only' or not words[4] then stop("expected only NAME ... after '%s'", words[2]) end
  local only = {}
  for i = 4, #words do
    for _, row in ipairs(section(words[2]).rows) do only[words[i]] = only[words[i]] or row.name == words[i] end
    if not only[words[i]] then stop("'%s' has no '%s', expected one of its outputs or named subexpressions", words[2], words[i]) end
  end
  return only
end

-- Rows that share a number, side by side or in columns where they are short.
local function group(kind, texts)
  local longest, out = 0, {}
  for _, text in ipairs(texts) do longest = math.max(longest, #text) end
  if #texts == 1 then return texts[1] end
  if longest < 32 and (kind == 'relation' or kind == 'domain') then return (table.concat(texts, ',\\quad '):gsub('&', '')) end
  local columns = #texts >= 6 and (longest < 45 and 3 or longest < 75 and 2) or 1
  for i, text in ipairs(texts) do out[i] = text .. (i == #texts and '' or i % columns ~= 0 and ' &\\qquad ' or ' \\\\\n') end
  return '\\begin{aligned}\n' .. table.concat(out) .. '\n\\end{aligned}'
end

-- The lines of a display of the rows of these kinds, those alone that `only` names: TeX and tag of each.
local function display(s, kinds, only)
  local taken, free, lines, last = {}, {}, {}, nil
  for _, row in ipairs(s.rows) do taken[row.kind == 'relation' and row.number] = true end
  for _, number in ipairs(s.numbers) do if not taken[number] then free[#free + 1] = number end end
  for _, row in ipairs(s.rows) do
    if kinds:find(row.kind, 1, true) and not (only and row.name ~= '' and not only[row.name]) then
      local aside = row.kind == 'let' and '\\text{with}\\quad ' or row.kind == 'domain' and '\\text{for}\\quad '
      local tag = not aside and (row.number ~= '' and row.number or #free > 0 and span_of(free)) or nil
      if not last or last.kind ~= row.kind or last.tag ~= tag then
        last = {kind = row.kind, tag = tag, texts = {}, aside = aside}
        lines[#lines + 1] = last
      end
      last.texts[#last.texts + 1] = row.tex
    end
  end
  for _, line in ipairs(lines) do line.tex = (line.aside or '') .. group(line.kind, line.texts) end
  return lines
end

-- Where a section stands for the index, and its numbers for references, once.
local placed = {}
local function targets(s)
  local out = placed[s.id] and '' or '\\place{' .. s.id .. '}'
  for _, name in ipairs(s.id:match '^eq%d+$' and not placed[s.id] and names_of(s) or {}) do out = out .. '\\target{' .. name .. '}' end
  placed[s.id] = true
  return out .. '%\n'
end

-- Lines that stand alone are aligned at their signs; groups have their own alignment and are centred.
local function equation_blocks(s, lines, suffix)
  suffix = suffix and ', ' .. suffix or ''
  local aligned, blocks, out = not web, pandoc.List(), {}
  for _, line in ipairs(lines) do aligned = aligned and not line.aside and not line.tex:find('aligned', 1, true) end
  for i, line in ipairs(lines) do
    local tex = (aligned or line.tex:find('aligned', 1, true)) and line.tex or line.tex:gsub('&', '')
    local tag = line.tag and line.tag .. suffix
    out[i] = tex .. (tag and '\\tag{' .. tag:gsub('–', '--') .. '}' or '\\notag')
    blocks:extend(web and box('equation', {pandoc.Plain {pandoc.Math('DisplayMath', upright(tex)),
                                                          pandoc.Span(tag and '(' .. tag .. ')' or '', {class = 'number'})}}) or {})
  end
  local kind = aligned and 'align' or 'gather'
  return web and blocks or {raw(targets(s) .. ('\\begin{%s}\n%s\n\\end{%s}'):format(kind, table.concat(out, ' \\\\\n'), kind))}
end

-- Code of more lines would leave much of a page empty, and may be torn on paper.
local LONGEST_KEPT = 26
local function code(text, path)
  if web then return {pandoc.CodeBlock(text, {class = path and 'c' or 'terminal', title = path})} end
  local listed = ('\\begin{lstlisting}[%s]\n%s\\end{lstlisting}'):format(path and '' or 'style=terminal', text)
  return box(select(2, text:gsub('\n', '')) < LONGEST_KEPT and 'keep' or 'torn',
             {raw(path and '\\begin{code}{' .. escape(path) .. '}\n' .. listed .. '\n\\end{code}' or listed)})
end

local function listing(name) return code(functions[name].text, functions[name].path) end

---- steps and verdicts ----

-- An equation number, a section or one formula of it, or a principle or property.
local function references(list)
  local out = {}
  for i, entry in ipairs(list) do
    local id, name = entry:match '^([^.]*)%.?(.*)$'
    if section_of[entry] then out[i] = '\\eq{' .. entry .. '}'
    elseif not sections[id] then out[i] = escape(entry)
    else
      out[i] = '\\eq{' .. sections[id].numbers[1]:gsub('%a$', '') .. '}'
               .. (name == '' and '' or '~$' .. (symbol[name] or name:gsub('_(.*)', '_{%1}')) .. '$')
    end
  end
  return table.concat(out, ', ')
end

-- The algebra: each line equalities one after the other, and how one comes to them.
local function algebra(lines)
  local blocks = pandoc.List()
  for _, line in ipairs(lines or {}) do
    local chain = table.concat(line.tex, ' = ')
    if web then blocks:insert(para(inlines(prose(line.how) .. ':'), ' ', {pandoc.Math('InlineMath', upright(chain))}))
    else
      local rows = line.tex[1] .. ' &= ' .. table.concat(line.tex, ' \\\\ &= ', 2)
      blocks:insert(raw(('\\derive{%s}{%s}{\\begin{aligned}%s\\end{aligned}}'):format(prose(line.how), chain, rows)))
    end
  end
  return blocks
end

-- In full in its chapter, in a line elsewhere.
local function step_blocks(s, brief)
  local title = pandoc.List(brief and page_of_step[s.id] and {pandoc.Link(pandoc.Code(s.id), page_of_step[s.id] .. '#step-' .. s.id)}
                            or {pandoc.Code(s.id)})
  local blocks = pandoc.List {para(inlines '$\\vdash$ ', title, inlines(': ' .. prose(s.title) .. '. ' .. references(s.from)
    .. (#s.to > 0 and ' $\\;\\rightarrow\\;$ ' .. references(s.to) or '') .. '. \\emph{Proved '
    .. (s.order and 'to order ' .. s.order or 'exactly') .. (web and '' or ', for ' .. prose(s.domain)) .. '.}'))}
  if brief then return box('step', blocks) end
  blocks:extend(not web and algebra(s.lines) or details('the algebra, line by line',
    join(algebra(s.lines), {pandoc.CodeBlock('for ' .. s.domain)})))
  if s.printed then
    local difference = s.printed.difference
    blocks:insert(para(inlines('As printed it fails: ' .. (difference and 'the sides differ by a multiple of $' .. difference .. '$'
                                                            or prose(s.printed.evidence)) .. '.')))
  end
  if (s.dropped or '') ~= '' then blocks:insert(para(inlines('Certified: ' .. prose(s.dropped) .. '.'))) end
  return box('step', blocks, 'step-' .. s.id)
end

local function name_of(v, text)
  return {web and pandoc.Link(text or v.id, 'verdicts.html#' .. v.id, '', {class = 'id'}) or pandoc.RawInline('latex', '\\claim{' .. v.id .. '}')}
end

-- On paper the evidence follows at once; on the web it stands with all verdicts, and at an equation's place.
local function verdict_blocks(v, evidence, id)
  local blocks = pandoc.List {para({pandoc.Strong(v.verdict .. ':')}, ' ', inlines(v.claim_tex .. ' (' .. prose(capital(v.where)) .. ')'), ' ', name_of(v))}
  if web and v.why_tex then blocks:insert(para(inlines(v.why_tex))) end
  if not web then blocks:extend(box('evidence', {para({pandoc.Emph('Evidence (' .. v.how .. '):')}, ' ', inlines(v.evidence_tex .. '.'))}))
  elseif evidence then blocks:extend(details('evidence, ' .. v.how, {para(inlines(v.evidence_tex .. '.'))})) end
  return box('verdict ' .. v.verdict:match '%a+', blocks, id)
end

---- within a line: each gives TeX, and whether it is mathematics ----

local inline = {}

function inline.number(words)
  if not (words[5] and #words <= 6) then stop 'expected <<number FILE ROW COLUMN DIGITS [SCALE]>>' end
  local path, found = data .. '/' .. words[2], {}
  local rows, heads = rows_of(read(path) or read(build .. '/' .. words[2]) or stop("no file '%s'", path))
  if not table.concat(heads, ','):find('%f[%w_]' .. words[4] .. '%f[^%w_]') then stop("'%s' has no column '%s'", path, words[4]) end
  for _, row in ipairs(rows) do
    if row.line:sub(1, #words[3] + 1) == words[3] .. ',' then found[#found + 1] = row[words[4]] end
  end
  if #found ~= 1 then stop("'%s' has %s '%s'", path, #found == 0 and 'no row' or #found .. ' rows', words[3]) end
  if not tonumber(found[1]) then stop("'%s' in '%s' is no number", found[1], path) end
  return decimal(found[1] * (words[6] or 1), words[5]), true
end

function inline.value(words)
  if not words[4] then stop 'expected <<value NAME DIGITS ARGUMENT ...>>' end
  local arguments = table.concat(words, ' ', 4)
  local found = (output_of(program .. ' ' .. arguments .. ' 2>/dev/null') or ''):match('%f[%w_]' .. words[2] .. ' += +(%S+)')
  return decimal(found or stop("coulomb-tether %s gives no '%s'", arguments, words[2]), words[3]), true
end

function inline.quote(_, text)
  local id, before, quoted, after = text:match '^quote +(%S+) ([^|]*)|([^|]+)|?([^|]*)$'
  if not id then stop 'expected <<quote ID before|text|after>>' end
  local v = verdicts[id] or stop("unknown verdict '%s', expected an id of data/verdicts.csv", id)
  if not v.evidence:find(before .. quoted .. after, 1, true) then
    stop("the evidence of '%s' does not read '%s'", id, before .. quoted .. after)
  end
  if not tonumber(quoted) then return prose(quoted), false end
  local digits, exponent = quoted:match '^(.*)e(.*)$'
  return digits and scientific(digits, exponent) or quoted, true
end

function inline.count(_, text)
  local counts = {steps = #steps, verdicts = #verdicts, inputs = errors[1].inputs, vectors = 0, misprints = 0, refuted = 0, ['not decidable'] = 0}
  for _, row in ipairs(gate) do counts.vectors = counts.vectors + (tonumber(row.vectors) or 0) end
  for _, v in ipairs(verdicts) do
    counts[v.verdict] = (counts[v.verdict] or 0) + 1
    if v.verdict == 'holds as corrected' and v.id:match '^equation%-' then counts.misprints = counts.misprints + 1 end
  end
  local what = text:match '^count +(.*)$'
  return counts[what] or stop("cannot count '%s', expected steps, vectors, inputs, misprints, verdicts or a kind of verdict", what), false
end

local function inline_directive(text)
  current = '<<' .. text .. '>>'
  local words = words_of(text)
  return (inline[words[1]] or stop("unknown directive '%s' within a line", words[1]))(words, text)
end

---- a line by itself: each gives blocks ----

local block = {}

function block.equation(words, text)
  local s, tex = section(words[2]), text:match '^equation +%S+ = (.+)$'
  if tex and #s.rows > 0 then stop("'%s' has its formula in the sheet, expected <<equation %s>>", s.id, s.id) end
  if tex then return equation_blocks(s, {{tex = tex, tag = span_of(s.numbers)}}) end
  if #s.rows == 0 then stop("'%s' has no formula in the sheet, expected <<equation %s = TEX>> or <<function %s>>", s.id, s.id, s.id) end
  local only = only_names(words)
  return equation_blocks(s, display(s, 'relation output let' .. (only and '' or ' domain'), only), qualified(s.id))
end

function block.printed(words)
  local s = section(words[2])
  if not s.reason then stop("'%s' is printed as the sheet has it, expected an equation with a printed form", s.id) end
  return join({para({pandoc.Strong 'As printed. '}, inlines(prose(s.reason)))},
              equation_blocks(s, display(s, 'printed', only_names(words)), 'as printed'))
end

block['function'] = function(words)
  local s = section(words[2])
  local name = gate[s.id] and gate[s.id]['function']
  if not functions[name] then stop('no function in ref/ with the header Eq. (%s)', s.numbers[1]) end
  return join(#s.rows == 0 and not web and {raw(targets(s))} or {}, listing(name))
end

function block.helper(words)
  return listing(functions[words[2]] and words[2] or stop("unknown function '%s', expected one of ref/", words[2]))
end

function block.step(words)
  local s = steps[words[2]] or stop("unknown derivation step '%s', expected one of paper/derivations.yaml", words[2])
  if s.step.finding ~= 'holds' then stop("step '%s' does not hold: %s", s.id, s.step.evidence) end
  return step_blocks(s)
end

function block.verdict(words)
  return verdict_blocks(verdicts[words[2]] or stop("unknown verdict '%s', expected an id of data/verdicts.csv", words[2]))
end

function block.findings(_, text)
  local kind, rows = text:match '^findings +(.*)$', {}
  if not ('|holds|holds as corrected|qualified|refuted|definition|not decidable|'):find('|' .. kind .. '|', 1, true) then stop("no verdict '%s'", kind) end
  for _, v in ipairs(verdicts) do
    if v.verdict == kind then
      rows[#rows + 1] = {join(inlines(v.claim_tex), ' ', name_of(v)), inlines(prose(capital(v.where))), inlines(v.why_tex or '')}
    end
  end
  if #rows == 0 then return {pandoc.Para 'None.'} end
  return box('findings', {table_of({'claim', 'where', 'why'}, {0.37, 0.19, 0.44}, rows)})
end

function block.run(_, text)
  local arguments = text:match '^run +(.*)$'
  return code('$ coulomb-tether ' .. arguments .. '\n'
              .. (output_of(program .. ' ' .. arguments) or stop('coulomb-tether %s failed', arguments)))
end

-- In units of Omega and L_ref, but for times: these are hours at the rate of Table 1.
function block.gains(words)
  local rows, hour = {}, nil
  for _, row in ipairs((rows_of(read(data .. '/table1.csv')))) do hour = row.name == 'Omega' and 3600 * row.computed or hour end
  for i = 2, #words do
    local c1, c2 = words[i]:match '^([^,]+),(.+)$'
    local arguments = (c1 and 'C1=' .. c1 .. ' C2=' .. c2 or 'n=' .. words[i]) .. ' Omega=1 L_ref=1'
    local found = {}
    for name, value in (output_of(program .. ' design ' .. arguments) or stop('coulomb-tether design %s failed', arguments)):gmatch '\n([%w_]+) = (%S+)' do
      found[name] = value
    end
    local cells = {c1 or words[i], decimal(found.C2, 4), decimal(-found.re4, 4), decimal(found.shortest, 4) .. '\\text{ to }' .. decimal(found.longest, 4),
                   decimal(found.box, 3), decimal(100 * found.deficit, 3) .. '\\,\\%', decimal(found.T / hour, 3), decimal(found.d / hour, 3)}
    for k, cell in ipairs(cells) do cells[k] = inlines('$' .. cell .. '$') end
    rows[i - 1] = cells
  end
  local heads = {'$n=C_1/\\Omega^2$', '$C_2/\\Omega$', 'decay $/\\Omega$', 'returns from $L/L_{\\mathrm{ref}}$', 'box', 'force may lack', '$T$ [h]', '$d$ [h]'}
  for k, head in ipairs(heads) do heads[k] = inlines(head) end
  return {table_of(heads, {0.12, 0.1, 0.12, 0.22, 0.1, 0.14, 0.1, 0.1}, rows)}
end

-- The sheet's quantities: "  NAME ...: {unit: U, ..., meaning: M}".
function block.symbols()
  local rows = {}
  for names, rest in read 'paper/equations.yaml':match '\nquantities:\n(.-)\n%a':gmatch '  ([^:\n]+): (%b{})' do
    local unit, meaning, list = rest:match 'unit: "?([^,"]*)', rest:match 'meaning: "?(.-)"?}$', {}
    for i, name in ipairs(words_of((names:gsub('"', '')))) do list[i] = '$' .. tex_of[name] .. '$' end
    rows[#rows + 1] = {inlines(table.concat(list, ', ')), inlines(unit == '-' and '' or prose(unit)), inlines(prose(meaning))}
  end
  return {table_of({'symbol', 'unit', 'meaning'}, {0.12, 0.13, 0.75}, rows)}
end

-- From the table that the gate leaves behind.
function block.index()
  local rows = {}
  for i, g in ipairs(gate) do
    local s, q = sections[g.id], qualified(g.id)
    rows[i] = {inlines('\\eq{' .. table.concat({s.numbers[1], #s.numbers > 1 and s.numbers[#s.numbers] or nil}, #s.numbers == 2 and '}, \\eq{' or '}--\\eq{')
                       .. '}' .. (q and ' ' .. q or '')),
               web and {pandoc.Link('¶', 'equations.html#' .. g.id)} or {pandoc.RawInline('latex', '\\pageref{place:' .. g.id .. '}')},
               {web and pandoc.Code(g['function']) or pandoc.RawInline('latex', '{\\condensed ' .. escape(g['function']) .. '}')},
               {pandoc.Str(g.tests)}, inlines(tonumber(g.error) and '$' .. decimal(g.error, 2) .. '$' or g.error),
               {pandoc.Str(g.vectors)}, {pandoc.Str(g.verdict)}}
  end
  return {table_of({'Eq.', web and '' or 'page', 'function', 'tests', {pandoc.Math('InlineMath', 'E\\le')}, 'vectors', 'verdict'},
                   {0.17, 0.06, 0.39, 0.07, 0.08, 0.09, 0.14}, rows)}
end

-- The equations, principles and properties that steps lead from or to, each once.
local function add_new(list, entries)
  for _, entry in ipairs(entries) do
    local name = entry:match '^[^.]*'
    name = sections[name] and sections[name].numbers[1]:gsub('%a$', '') or name
    if not list[name] then list[name], list[#list + 1] = true, name end
  end
end

-- Each equation with all that belongs to it.
function block.places()
  local blocks = pandoc.List()
  for _, s in ipairs(sections) do
    local g, q = gate[s.id], qualified(s.id)
    blocks:insert(pandoc.Header(2, join({pandoc.Link('¶', '#' .. s.id, '', {class = 'permalink'})}, ' (' .. span_of(s.numbers) .. ') ',
                                        inlines(prose(s.title)), q and ', ' .. q or ''), {id = s.id}))
    for _, name in ipairs(s.id:match '^eq%d+$' and names_of(s) or {}) do blocks:insert(raw('<a id="eq:' .. name .. '"></a>')) end
    blocks:extend(equation_blocks(s, s.defined and {{tex = s.defined, tag = span_of(s.numbers)}} or display(s, 'relation output let domain'), q))
    if s.note then blocks:insert(para(inlines(prose(s.note)))) end
    if s.reason then blocks:extend(block.printed {'printed', s.id}) end
    local said = {}  -- once where (2a), (2b) and (2c) have the same
    for _, number in ipairs(s.numbers) do
      local v = verdicts['equation-' .. number]
      local same = v and v.verdict .. v.claim .. (v.why or '') .. v.evidence
      if v and s.id:match '^eq%d+$' and not said[same] then blocks:extend(verdict_blocks(v, true)) end
      if v then said[same] = true end
    end
    local f = g and functions[g['function']]
    if f then blocks:extend(details('C: <code>' .. g['function'] .. '</code> in <code>' .. f.path .. '</code>', listing(g['function']))) end
    local to, from, proofs = {}, {}, pandoc.List()
    for _, step in ipairs(steps) do
      local ends = {}
      for _, side in ipairs {'to', 'from'} do
        for _, entry in ipairs(step[side]) do ends[side] = ends[side] or (section_of[entry] or entry:match '^[^.]*') == s.id end
      end
      if ends.to then add_new(to, step.from); proofs:extend(step_blocks(step, true)) end
      if ends.from then add_new(from, step.to) end
    end
    if #to > 0 then blocks:insert(para({pandoc.Strong 'Comes from '}, inlines(references(to)))) end
    if #from > 0 then blocks:insert(para({pandoc.Strong 'Leads to '}, inlines(references(from)))) end
    if #proofs > 0 then blocks:extend(details('proof', proofs)) end
    if g and g.vectors ~= '-' then
      blocks:insert(para({pandoc.Strong 'Error and vectors. '}, inlines(tonumber(g.error) and 'The largest backward error of the function is $E='
        .. decimal(g.error, 2) .. '$ on ' .. errors[1].inputs .. ' random inputs;' or 'Judged by correct digits;'), ' ' .. g.tests .. ' tests, ',
        {pandoc.Link(g.vectors .. ' golden vectors', 'data/' .. s.id .. '.csv.gz')}, '. How to check yours:'))
      blocks:extend(code('coulomb-tether conform --only ' .. s.id .. ' -- ./my-client'))
    end
  end
  return blocks
end

function block.verdicts()
  local blocks = pandoc.List()
  for _, v in ipairs(verdicts) do blocks:extend(verdict_blocks(v, true, v.id)) end
  return blocks
end

---- figures ----

-- The lines of the graph of derivations at one of whose ends a step of the chapter stands, and the nodes there.
local function graph_of(chapter)
  local graph, used, nodes, edges = made 'derivations.gv', {}, {}, {}
  for from, to in graph:gmatch '\n  (%b"") %-> (%b"")' do
    local step = read('paper/' .. chapter .. '.md'):find('\n<<step ' .. from:sub(2, -2) .. '>>', 1, true)
                 or read('paper/' .. chapter .. '.md'):find('\n<<step ' .. to:sub(2, -2) .. '>>', 1, true)
    if step then used[from], used[to], edges[#edges + 1] = true, true, from .. ' -> ' .. to end
  end
  for name, attributes in graph:gsub(', tooltip="[^\n]*"', ''):gmatch '\n  (%b"") %[([^\n]*)%];' do
    local number, step = name:match '^"(%d[^ "]*)', not attributes:match 'shape'
    local url = number and 'equations.html#eq:' .. number or step and '#step-' .. name:sub(2, -2)
    if used[name] then
      nodes[#nodes + 1] = ('%s [%s%s%s]'):format(name, url and 'URL="' .. url .. '", ' or '', step and '' or 'style=solid, ', attributes)
    end
  end
  return 'digraph chapter { ranksep=0.3; nodesep=0.06; margin=0; node [fontname="Helvetica", fontsize=10, height=0.1, width=0.1, '
         .. 'margin="0.03,0.02", shape=box, style=filled, fillcolor="#eeeeee"];' .. table.concat(nodes, ';') .. ';' .. table.concat(edges, ';') .. '}'
end

-- The picture within the page, without what a style sheet says better.
local function inline_svg(chapter)
  local svg = pandoc.pipe('dot', {'-Tsvg'}, graph_of(chapter)):match '<svg.*'
  return (svg:gsub('<title>.-</title>\n', ''):gsub('<!%-%-.-%-%->\n', ''):gsub('<g id="[en].-">\n', ''):gsub('</g>\n', ''):gsub('</svg>', '</g></svg>')
             :gsub(' font%-%a+="[^"]*"', ''):gsub(' text%-anchor="middle"', ''):gsub(' xlink:title="[^"]*"', ''):gsub(' stroke="black"', ''))
end

local function figure(el)
  local kind, name = el.src:match '^(%a+):(.*)$'
  current = '](' .. el.src .. ')'
  local id = (kind == 'graph' and 'fig:graph-' or 'fig:') .. (name or '')
  local source = kind == 'plot' and 'paper/figures/plot-' .. name .. '.gp' or kind == 'graph' and 'paper/' .. name .. '.md'
  if not (source and read(source)) then stop("unknown picture '%s', expected plot:NAME or graph:CHAPTER", el.src) end
  if #el.caption == 0 then stop("'%s' has no caption", el.src) end
  local label, drawn = labels[id] and labels[id].text, nil  -- pages between the chapters have none
  if kind == 'graph' and web then drawn = inline_svg(name)
  elseif kind == 'graph' then pandoc.pipe('dot', {'-Tpdf', '-o', build .. '/paper/graph-' .. name .. '.pdf'}, graph_of(name))
  else drawn = ('<img src="plot-%s.svg" alt="%s">'):format(name, label and 'Figure ' .. label or '') end
  if web then
    return {raw('<figure id="' .. id .. '">' .. drawn .. '<figcaption>'), pandoc.Plain(join(label and {pandoc.Strong('Figure ' .. label .. '. ')} or '', el.caption)),
            raw '</figcaption></figure>'}
  end
  return {raw(('\\begin{figure}[tbp]\\centering\\%s{%s}\\def\\thefigure{%s}'):format(kind, name, label)),
          pandoc.Plain(join({pandoc.RawInline('latex', '\\caption{')}, el.caption, {pandoc.RawInline('latex', '}\\label{' .. id .. '}\\end{figure}')}))}
end

---- the document ----

local function is_directives(content)
  for _, el in ipairs(content) do
    local name = el.t == 'Code' and el.text:match '^<<(%a*).*>>$'
    if el.t ~= 'SoftBreak' and (not name or inline[name]) then return false end
  end
  return true
end

local function paragraph(el)
  if #el.content == 1 and el.content[1].t == 'Image' then return figure(el.content[1]) end
  if not is_directives(el.content) then return nil end
  local blocks = pandoc.List()
  for _, part in ipairs(el.content) do
    if part.t == 'Code' then
      current = part.text
      local words = words_of(part.text:sub(3, -3))
      blocks:extend((block[words[1]] or stop("unknown directive '%s'", words[1]))(words, part.text:sub(3, -3)))
    end
  end
  return blocks
end

local filter = {
  Code = function(el)
    local text = el.text:match '^<<(.*)>>$'
    if not text and el.text:find('<<', 1, true) then
      current = el.text
      stop "'<<' without its '>>' on the same line"
    end
    if not text then return nil end
    local tex, mathematics = inline_directive(text)
    return mathematics and pandoc.Math('InlineMath', tostring(tex)) or inlines(tostring(tex))
  end,
  Math = function(el)
    return pandoc.Math(el.mathtype, upright(el.text:gsub('`<<(.-)>>`', function(text) return tostring((inline_directive(text))) end)))
  end,
  Link = link,
  Header = function(el)
    local label = web and el.level == 1 and labels[el.identifier]
    if label and tonumber(label.text) then el.content = join(label.text .. ' ', el.content) end
    return el
  end,
  Span = function(el)
    if not web and el.identifier:match '^ref:' then return pandoc.RawInline('latex', '\\phantomsection\\label{' .. el.identifier .. '}') end
  end,
  Div = function(el)
    if not web and el.classes[1] == 'recommended' then return box('recommended', el.content) end
  end,
}

-- What the templates ask for: the version, the day, the data; for the web the pages, and those before and after this one.
local function describe(meta)
  meta.version = output_of(program .. ' --version'):match '(%S+)%s*$'
  meta.date = os.getenv 'CT_DATE' or ''
  meta.fingerprint = output_of('$(command -v sha256sum || echo shasum -a 256) ' .. word(data .. '/datapackage.json')):sub(1, 16)
  meta.title, meta.pages = 'The Coulomb tether, checked by machine', pages
  for i, page in ipairs(pages) do
    if page.file == os.getenv 'CT_PAGE' then meta.title, meta.before, meta.after = page.title, pages[i - 1], pages[i + 1] end
  end
  return meta
end

function Pandoc(doc)
  doc.blocks = pandoc.walk_block(pandoc.Div(doc.blocks), {Para = paragraph}).content
  doc.blocks = pandoc.walk_block(pandoc.Div(doc.blocks), filter).content
  doc.meta = describe(doc.meta)
  return doc
end
