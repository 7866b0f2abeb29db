-- The weaver: a reader of pandoc that puts what the build found in place of the directives in paper/*.md, for LaTeX and for
-- the web. What it puts there is Markdown. What cannot be found is told with file and line, and nothing is woven.
--
--     pandoc -f paper/weave.lua -t latex CHAPTER.md ...
--
-- From the environment: CT_PROGRAM, CT_DATA, CT_BUILD; CT_DATE, the day of the source; for the web CT_PAGE, the page's name.
-- A line by itself:
--   <<equation ID [only NAME ...]>>   the formula from the sheet as parsed, under its number
--   <<equation ID = TEX>>             the same for a section of the sheet that has no formula
--   <<printed ID [only NAME ...]>>    what the paper has instead, and why it cannot be
--   <<function ID>>                   the function of ref/ that carries the equation's number;  <<helper NAME>>  another one
--   <<step ID>>                       a derivation step, its algebra, where it holds, and what is dropped
--   <<verdict ID>>                    a verdict;  <<findings VERDICT>>  a table of those that have it, and why
--   <<run ARGUMENT ...>>              a command of the program, and what it prints
--   <<rows KEY ...>> LINE             the line for each key, in place of @; @1 and @2 are the parts of a key A,B
--   <<symbols>>, <<index>>            the quantities of the sheet; the index of equations
--   <<places>>, <<verdicts>>          for the web: each equation with all that belongs to it; all verdicts
--   ![CAPTION](plot:NAME)             a plot of data/;  ![CAPTION](graph:CHAPTER)  what a chapter's steps lead from and to
-- Within a line, the first two and a number that is quoted between dollars:
--   <<number FILE ROW COLUMN DIGITS[*SCALE]>>   from data/FILE or build/FILE, the row by its first column, or columns: A,B
--   <<value NAME DIGITS[*SCALE] ARGUMENT ...>>  what a command of the program finds
--   <<quote ID before|text|after>>    `text`, provided that the evidence of a verdict reads so
--   <<count WHAT>>                    steps, vectors, inputs, misprints, verdicts, or one kind of verdict
--   [(7)](#eq:7), [section](#ID), [Figure](#fig:NAME), [](#ref:NAME)            have to lead somewhere

local page = os.getenv 'CT_PAGE'
local web = page ~= nil
-- A word of the shell: a folder may have any name.
local function word(text) return "'" .. text:gsub("'", "'\\''") .. "'" end

local program, data, build = word(os.getenv 'CT_PROGRAM' or ''), os.getenv 'CT_DATA', os.getenv 'CT_BUILD'
local where, stops = '', 0  -- file and line of what is being woven; how many of them could not be

local function stop(text, ...)
  io.stderr:write(where, ': ', text:format(...), '\n')
  stops = stops + 1
  error(stop)
end

---- reading ----

local function read(path)
  local file = io.open(path)
  local text = file and file:read 'a'
  if file then file:close() end
  return text
end

local function made(path) return read(build .. '/' .. path) or error('no ' .. build .. '/' .. path .. ': run make check') end

local function output_of(command)
  local pipe = io.popen(command)
  local text = pipe:read 'a'
  return pipe:close() and text or nil
end

local function run(words) return output_of(program .. ' ' .. words) or stop('coulomb-tether %s failed', words) end

local function split(text, pattern)
  local parts = {}
  for part in text:gmatch(pattern or '%S+') do parts[#parts + 1] = part end
  return parts
end

local P, R, S, C, Cs, Ct = lpeg.P, lpeg.R, lpeg.S, lpeg.C, lpeg.Cs, lpeg.Ct

-- JSON is Lua but for brackets and colons. Entries can be found by their id.
local quoted = '"' * (P '\\' * 1 + (1 - P '"'))^0 * '"'
local as_lua = Cs((C(quoted) * ':' / '[%1]=' + quoted + P '[' / '{' + P ']' / '}' + 1)^0)
local function entries_of(path)
  local all = load('return ' .. as_lua:match(made(path)))()
  local list = all.derivations and all.derivations.steps or all.claims or all.errors
  for _, entry in ipairs(list) do list[entry.id] = entry end
  return list
end

-- The rows of a CSV file by its columns' names; no field of ours has a quotation mark or a line break in it.
local field = '"' * C((1 - P '"')^0) * '"' + C((1 - S ',\n')^0)
local records = Ct((Ct(field * (',' * field)^0) * '\n')^0)
local function rows_of(text)
  local rows = records:match(text)
  local heads = table.remove(rows, 1)
  for _, row in ipairs(rows) do
    for i, head in ipairs(heads) do row[head] = row[i] end
  end
  return rows
end

local steps, verdicts, errors = entries_of 'derivations.json', entries_of 'claims.json', entries_of 'errors.json'
local gate = rows_of(made 'gate.csv')
for _, row in ipairs(gate) do gate[row.id] = row end

local counts = {steps = #steps, verdicts = #verdicts, inputs = errors[1].inputs, vectors = 0, misprints = 0, refuted = 0}
for _, row in ipairs(gate) do counts.vectors = counts.vectors + (tonumber(row.vectors) or 0) end
for _, v in ipairs(verdicts) do
  counts[v.verdict] = (counts[v.verdict] or 0) + 1
  if v.verdict == 'holds as corrected' and v.kind == 'equation' then counts.misprints = counts.misprints + 1 end
end

-- The sheet as `coulomb-tether typeset` prints it: ID, KIND, NUMBER, NAME, TEX by tabs.
local sections, symbol, tex_of = {}, {}, {}
for id, kind, number, name, tex in run 'typeset':gmatch '([^\t]*)\t([^\t]*)\t([^\t]*)\t([^\t]*)\t([^\n]*)\n' do
  local s = sections[id] or {id = id, numbers = {}, rows = {}}
  if kind == 'symbol' then
    tex_of[name] = tex
    symbol[name] = #name > 1 and tex or nil  -- a letter by itself may be any word
  elseif not sections[id] then sections[id], sections[#sections + 1] = s, s end
  if kind == 'number' then table.insert(s.numbers, number)
  elseif kind == 'title' or kind == 'note' or kind == 'reason' then s[kind] = tex
  else table.insert(s.rows, {kind = kind, number = number, name = name, tex = tex}) end
end
symbol.stable = nil  -- a word in prose that happens to be a quantity
for name in ('pi lambda mu phi kappa epsilon rho omega cos sin tan'):gmatch '%a+' do symbol[name] = '\\' .. name end

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
  for path in output_of 'ls paper/[0-9]*.md':gmatch '%S+' do
    local file, text = path:match '([^/]*)%.md$' .. '.html', read(path)
    local function label(id, name) labels[id] = {text = name, page = file} end
    for hashes, title, id, rest in ('\n' .. text):gmatch '\n(#+) ([^\n]-) {#(%S+)([^}\n]*)}' do
      local chapter = hashes == '#' and rest == ''
      number = number + (chapter and 1 or 0)
      label(id, rest == '' and tostring(number) or title)
      if hashes == '#' then pages[#pages + 1] = {file = file, title = title, number = chapter and tostring(number) or ''} end
    end
    for kind, name in text:gmatch '%]%((%a+):([%w-]+)%)' do
      local ours = kind == 'graph' or not name:match '^%d%a?$'
      letters = letters + (ours and 1 or 0)
      label('fig:' .. (kind == 'graph' and 'graph-' or '') .. name, ours and string.char(64 + letters) or name)
    end
    for id in text:gmatch '{#(ref:%w+)}' do
      cited = cited + 1
      label(id, '[' .. cited .. ']')
    end
    for id in text:gmatch '\n<<step ([%w_]+)>>' do page_of_step[id] = file end
    for id, tex in text:gmatch '\n<<equation (%w+) = ([^\n]*)>>' do (sections[id] or {}).defined = tex end
  end
end

-- A reference has its number behind it.
local function link(text, id)
  local number, label = id:match '^eq:(.*)$', labels[id]
  if number and not section_of[number] then stop("unknown equation '%s', expected a number of the paper", number) end
  if not number and not label then stop("unknown reference '%s', expected a section, figure or reference", id) end
  if label then text = text .. (text == '' and '' or '\u{a0}') .. label.text end
  if not web then return ('\\hyperref[%s]{%s}'):format(id, text) end
  return ('[%s](%s#%s)'):format(text, label and label.page or 'equations.html', id)
end
local function equation_link(number) return link('(' .. number .. ')', 'eq:' .. number) end

---- Markdown ----

local function formula(tex) return '$' .. tex:gsub('%s+$', '') .. '$' end

local function scientific(digits, exponent)
  exponent = tonumber(exponent)
  return digits .. (exponent == 0 and '' or ('\\times 10^{%d}'):format(exponent))
end

-- A text of the sheet, of a step or of the program, without marks: its symbols, its signs and powers that are numbers become
-- mathematics. In a text that has no units, or when it asks for it, so do names of one letter, with a digit or an index.
local digit, letter, sign = R '09', R('az', 'AZ'), P(false)
local real = digit^1 * ('.' * digit^1)^-1
for text, name in ('<= le >= ge << ll -> to +- pm -+ mp * cdot'):gmatch '(%S+) (%S+)' do
  -- with the digits behind it: a dollar before a digit is none
  sign = sign + P(text) * C(real^-1) / function(digits) return formula('\\' .. name .. ' ' .. digits) end
end
sign = sign + (lpeg.B(S ' (') + -lpeg.B(1)) * (P '-' * (real + #(letter + ' '))) / formula
local number = C(P '-'^-1 * real) * 'e' * C(S '+-'^-1 * digit^1) / function(...) return formula(scientific(...)) end
               + P '^' * C(P '-'^-1 * digit^1) / '$^{%1}$'
local function marked(letters)
  local function named(text)
    local index = letters and text:match '^%a([_%d]?%w*)$'
    if symbol[text] then return formula(symbol[text]) end
    if index and (#text < 3 and not index:match '%a' or text:sub(2, 2) == '_') then
      return formula(text:sub(1, 1) .. (index == '' and '' or '_{\\mathrm{' .. index:gsub('_', '') .. '}}'))
    end
    return text:gsub('_', '\\_')
  end
  local article = P 'a' * #(P ' ' * letter)
  local name = letter * (letter + digit + '_' + P "'" * #letter)^0
  return Cs((number + digit * letter / '%0' + article + C(name) / named + sign + S '\\`*_{}[]<>#|~^$@"' / '\\%0' + 1)^0)
end
local with_units, with_letters = marked(false), marked(true)
local function prose(text, letters)
  return ((letters and with_letters or with_units):match(text):gsub('%$%$', ' '))
end
local function sentence(text) return prose(text:sub(1, 1):upper() .. text:sub(2)) end

-- TeX of the program: its mathematics stands between dollars.
local dollars = '$' * C((1 - P '$')^0) * '$' / formula
local from_tex = Cs((dollars + P '~' / '\u{a0}' + P '\\textmu{}' / 'µ' + P '\\' * 1 + sign + S '`[]#|^@"<>' / '\\%0' + 1)^0)

-- So many significant digits, with a power of ten where the number is far from one: "3", or "3*SCALE".
local function decimal(value, form)
  local digits, scale = form:match '^(%d+)%*?(.*)$'
  value = value * (tonumber(scale) or 1)
  local mantissa, exponent = ('%%.%de'):format(digits - 1):format(value):match '^(.*)e(.*)$'
  exponent = tonumber(exponent)
  if value ~= 0 and (exponent < -3 or exponent > 5) then return scientific(mantissa, exponent) end
  return ('%%.%df'):format(math.max(digits - 1 - exponent, 0)):format(value)
end

-- What one of the two formats has alone; the other leaves it out.
local function raw(text, format) return ('\n\n```{=%s}\n%s\n```\n\n'):format(format or 'latex', text) end
local function raw_inline(text) return '`' .. text .. '`{=latex}' end
-- Blocks of a class: what LaTeX calls an environment.
local function box(class, text, id) return ('\n\n::: {.%s%s}\n%s\n:::\n\n'):format(class, id and ' #' .. id or '', text) end
-- What a reader opens on demand.
local function details(summary, text)
  return raw('<details><summary>' .. summary .. '</summary>', 'html') .. text .. raw('</details>', 'html')
end

local function table_of(heads, widths, rows)
  local lines = {table.concat(heads, ' | '), ''}
  for i, width in ipairs(widths) do lines[2] = lines[2] .. (i > 1 and '|' or '') .. ('-'):rep(width) end
  for _, row in ipairs(rows) do lines[#lines + 1] = table.concat(row, ' | ') end
  return '\n\n| ' .. table.concat(lines, ' |\n| ') .. ' |\n\n'
end

---- equations ----

local qualifier = {lin = 'small angles', inv = 'inverse', exact = 'exact', roots = 'roots', flow = 'flow',
                   rk4 = 'Runge-Kutta'}
local function qualified(id) return qualifier[id:match '^eq%d+(.*)$' or id:match '^%a+%d?'] end

-- {2a, 2b, 2c} as the reader sees it: 2a to 2c.
local function span_of(list) return #list < 2 and list[1] or list[1] .. (#list == 2 and ', ' or '–') .. list[#list] end

local function section(id)
  return sections[id] or stop("unknown equation '%s', expected a section of paper/equations.yaml", id)
end

-- Rows that share a number, side by side or in columns where they are short.
local function group(kind, texts)
  local longest = 0
  for _, text in ipairs(texts) do longest = math.max(longest, #text) end
  if #texts == 1 then return texts[1] end
  if longest < 32 and (kind == 'relation' or kind == 'domain') then
    return (table.concat(texts, ',\\quad '):gsub('&', ''))
  end
  local columns, out = #texts >= 6 and (longest < 45 and 3 or longest < 75 and 2) or 1, ''
  for i, text in ipairs(texts) do
    out = out .. text .. (i == #texts and '' or i % columns ~= 0 and ' &\\qquad ' or ' \\\\\n')
  end
  return '\\begin{aligned}\n' .. out .. '\n\\end{aligned}'
end

-- The lines of a display of the rows of these kinds, those alone that `ID only NAME ...` names: TeX and tag of each.
local function display(s, kinds, words)
  local only, taken, free, lines, last = {}, {}, {}, {}, {}
  if words[2] and (words[2] ~= 'only' or not words[3]) then stop("expected only NAME ... after '%s'", words[1]) end
  for i = 3, #words do only[words[i]] = true end
  for _, row in ipairs(s.rows) do
    taken[row.kind == 'relation' and row.number], only[row.name] = true, only[row.name] and 'found'
  end
  for name, found in pairs(only) do
    if found ~= 'found' then stop("'%s' has no '%s', expected one of its outputs or named subexpressions", s.id, name) end
  end
  for _, number in ipairs(s.numbers) do if not taken[number] then free[#free + 1] = number end end
  for _, row in ipairs(s.rows) do
    if kinds:find(row.kind, 1, true) and (not words[2] or row.name == '' and row.kind ~= 'domain' or only[row.name]) then
      local aside = row.kind == 'let' and '\\text{with}\\quad ' or row.kind == 'domain' and '\\text{for}\\quad '
      local tag = not aside and (row.number ~= '' and row.number or #free > 0 and span_of(free)) or nil
      if last.kind ~= row.kind or last.tag ~= tag then
        last = {kind = row.kind, tag = tag, aside = aside}
        lines[#lines + 1] = last
      end
      last[#last + 1] = row.tex
    end
  end
  for _, line in ipairs(lines) do line.tex = (line.aside or '') .. group(line.kind, line) end
  return lines
end

-- Where a section stands for the index and its numbers for references, once.
local placed = {}
local function targets(s)
  local out = web and '' or '\\place{' .. s.id .. '}'
  for _, name in ipairs(s.id:match '^eq%d+$' and names_of(s) or {}) do
    out = out .. (web and '<a id="eq:%s"></a>' or '\\target{%s}'):format(name)
  end
  if placed[s.id] then return '' end
  placed[s.id] = true
  return out
end

-- Lines that stand alone are aligned at their signs; groups have their own alignment and are centred.
local function equation(s, lines, suffix)
  local aligned, out = not web, {}
  for _, line in ipairs(lines) do aligned = aligned and not line.aside and line.tex:match '^[^&]*&[^&]*$' end
  for i, line in ipairs(lines) do
    local tex = (aligned or line.tex:find('{aligned}', 1, true)) and line.tex or line.tex:gsub('&', '')
    local tag = line.tag and line.tag .. (suffix and ', ' .. suffix or '')
    out[i] = web and box('equation', '$$' .. tex .. '$$' .. (tag and '[(' .. tag .. ')]{.number}' or ''))
             or tex .. (tag and '\\tag{' .. tag:gsub('–', '--') .. '}' or '\\notag')
  end
  if web then return table.concat(out) end
  local kind = aligned and 'align' or 'gather'
  return raw('\\joined' .. targets(s) .. ('%%\n\\begin{%s}\n%s\n\\end{%s}'):format(kind, table.concat(out, ' \\\\\n'), kind))
end

-- CSV goes on in the next line, where paper ends.
local PAPER = 125
local function folded(line)
  local head = #line > PAPER and line:sub(1, PAPER):match('^.*,')
  return head and head .. '\n    ' .. folded(line:sub(#head + 1)) or line
end

-- Code of more lines would leave much of a page empty, and may be torn on paper.
local LONGEST_KEPT = 26
local function code(text, path)
  if web then return ('\n\n```{.%s}\n%s\n```\n\n'):format(path and 'c title="' .. path .. '"' or 'terminal', text) end
  local kept = select(2, text:gsub('\n', '')) < LONGEST_KEPT and 'keep' or 'torn'
  local listed = ('\\begin{lstlisting}[%s]\n%s\\end{lstlisting}'):format(path and '' or 'style=terminal', path and text or text:gsub('[^\n]+', folded))
  if path then listed = ('\\begin{code}{%s}\n%s\n\\end{code}'):format(path:gsub('_', '\\_'), listed) end
  return raw(('\\begin{%s}\n%s\n\\end{%s}'):format(kept, listed, kept))
end
local function listing(name) return code(functions[name].text, functions[name].path) end

---- steps and verdicts ----

-- Equation numbers, sections or formulas of them, principles and properties; as a whole, each once.
local function references(list, whole)
  local out = {}
  for _, entry in ipairs(list) do
    local id, name = entry:match '^([^.]*)%.?(.*)$'
    local number = sections[id] and sections[id].numbers[1]:gsub('%a$', '') or section_of[entry] and entry
    local text = number and equation_link(number) or (whole and id or entry):gsub('_', '\\_')
    if number and name ~= '' and not whole then
      text = text .. '\u{a0}' .. formula(symbol[name] or name:gsub('_(.*)', '_{%1}'))
    end
    if not (whole and out[text]) then out[text], out[#out + 1] = true, text end
  end
  return table.concat(out, ', ')
end

-- The algebra: each line equalities one after the other, and how one comes to them.
local function algebra(lines)
  local out = ''
  for _, line in ipairs(lines) do
    local how, chain = prose(line.how, true), table.concat(line.tex, ' = ')
    local rows = line.tex[1] .. ' &= ' .. table.concat(line.tex, ' \\\\ &= ', 2)
    out = out .. '\n\n' .. (web and how .. ': ' .. formula(chain)
      or raw_inline '\\derive{' .. how .. raw_inline(('}{%s}{\\begin{aligned}%s\\end{aligned}}'):format(chain, rows)))
  end
  return out .. '\n\n'
end

-- In full in its chapter, in a line elsewhere.
local function step_of(s, brief)
  local name, chapter = '`' .. s.id .. '`', page_of_step[s.id]
  if brief and chapter then name = ('[%s](%s#step-%s)'):format(name, chapter, s.id) end
  local leads = references(s.from) .. (#s.to > 0 and ' $\\;\\rightarrow\\;$ ' .. references(s.to) or '')
  local proved = (s.order and 'to order ' .. s.order or 'exactly') .. (web and '' or ', for ' .. prose(s.domain, true))
  local text = ('$\\vdash$ %s: %s. %s. *Proved %s.*'):format(name, prose(s.title, true), leads, proved)
  if brief then return box('step', text) end
  local lines = algebra(s.lines)
  text = text .. (web and details('the algebra, line by line', lines .. '```\nfor ' .. s.domain .. '\n```') or lines)
  if s.printed then
    local by = s.printed.difference
    text = text .. ('\n\nAs printed it fails: %s.'):format(by and 'the sides differ by a multiple of ' .. formula(by)
                                                          or prose(s.printed.evidence))
  end
  local dropped = (s.dropped or ''):gsub('([%w_]+) %-(%d[%d.e+-]*) %.%.%. %2', '|%1| <= %2')
  if dropped ~= '' then text = text .. '\n\nCertified: ' .. prose(dropped) .. '.' end
  return box('step', text, 'step-' .. s.id)
end

local function name_of(v)
  return web and ('[%s](verdicts.html#%s){.id}'):format(v.id, v.id) or raw_inline('\\claim{' .. v.id .. '}')
end

-- On paper the evidence follows at once; on the web it stands with all verdicts, and at an equation's place.
local function verdict_of(v, evidence, id)
  local claim, proof = from_tex:match(v.claim_tex), from_tex:match(v.evidence_tex) .. '.'
  local text = ('**%s:** %s (%s) %s\n\n'):format(v.verdict, claim, sentence(v.where), name_of(v))
  if not web then text = text .. box('evidence', '*Evidence (' .. v.how .. '):* ' .. proof)
  else text = text .. from_tex:match(v.why_tex or '') .. (evidence and details('evidence, ' .. v.how, proof) or '') end
  return box('verdict .' .. v.verdict:match '%a+', text, id)
end

---- within a line ----

local inline = {}

function inline.number(words)
  local file, key, column, form = table.unpack(words)
  if #words ~= 4 then stop 'expected <<number FILE ROW COLUMN DIGITS[*SCALE]>>' end
  local path, found, parts = data .. '/' .. file, {}, split(key, '[^,]+')
  local rows = rows_of(read(path) or read(build .. '/' .. file) or stop("no file '%s'", path))
  if not rows[1][column] then stop("'%s' has no column '%s'", path, column) end
  for _, row in ipairs(rows) do
    if table.concat(row, ',', 1, #parts) == key then found[#found + 1] = row[column] end
  end
  if #found ~= 1 then stop("'%s' has %s '%s'", path, #found == 0 and 'no row' or #found .. ' rows', key) end
  return decimal(tonumber(found[1]) or stop("'%s' in '%s' is no number", found[1], path), form)
end

function inline.value(words)
  if not words[3] then stop 'expected <<value NAME DIGITS[*SCALE] ARGUMENT ...>>' end
  local arguments = table.concat(words, ' ', 3)
  local found = (output_of(program .. ' ' .. arguments .. ' 2>/dev/null') or ''):match('%f[%w_]' .. words[1] .. ' += +(%S+)')
  return decimal(found or stop("coulomb-tether %s gives no '%s'", arguments, words[1]), words[2])
end

function inline.quote(_, text)
  local id, before, quoted, after = text:match '^(%S+) ([^|]*)|([^|]+)|?([^|]*)$'
  if not id then stop 'expected <<quote ID before|text|after>>' end
  local v = verdicts[id] or stop("unknown verdict '%s', expected an id of data/verdicts.csv", id)
  if not v.evidence:find(before .. quoted .. after, 1, true) then
    stop("the evidence of '%s' does not read '%s'", id, before .. quoted .. after)
  end
  return tonumber(quoted) and (quoted:gsub('^(.*)e(.*)$', scientific)) or prose(quoted)
end

function inline.count(_, what)
  return tostring(counts[what] or stop("cannot count '%s', expected %s or a kind of verdict", what,
                                       'steps, vectors, inputs, misprints, verdicts'))
end

---- a line by itself ----

local block = {}

function block.equation(words, text)
  local s, tex = section(words[1]), text:match '^%S+ = (.+)$'
  if tex and #s.rows > 0 then stop("'%s' has its formula in the sheet, expected <<equation %s>>", s.id, s.id) end
  if tex then return equation(s, {{tex = tex, tag = span_of(s.numbers)}}) end
  if #s.rows == 0 then stop("'%s' has no formula in the sheet, expected <<equation %s = TEX>>", s.id, s.id) end
  return equation(s, display(s, 'relation output let domain', words), qualified(s.id))
end

function block.printed(words)
  local s = section(words[1])
  if not s.reason then stop("'%s' is printed as the sheet has it, expected an equation with a printed form", s.id) end
  return '\n\n**As printed.** ' .. prose(s.reason, true) .. equation(s, display(s, 'printed', words), 'as printed')
end

block['function'] = function(words)
  local s = section(words[1])
  local name = gate[s.id] and gate[s.id]['function']
  if not functions[name] then stop('no function in ref/ with the header Eq. (%s)', s.numbers[1]) end
  return (#s.rows == 0 and not web and raw(targets(s)) or '') .. listing(name)
end

function block.helper(words)
  return listing(functions[words[1]] and words[1] or stop("unknown function '%s', expected one of ref/", words[1]))
end

function block.step(words)
  local s = steps[words[1]] or stop("unknown derivation step '%s', expected one of paper/derivations.yaml", words[1])
  if s.step.finding ~= 'holds' then stop("step '%s' does not hold: %s", s.id, s.step.evidence) end
  return step_of(s)
end

function block.verdict(words)
  return verdict_of(verdicts[words[1]] or stop("unknown verdict '%s', expected an id of data/verdicts.csv", words[1]))
end

function block.findings(_, kind)
  local rows = {}
  if not counts[kind] then stop("no verdict '%s'", kind) end
  for _, v in ipairs(verdicts) do
    local claim, why = from_tex:match(v.claim_tex), from_tex:match(v.why_tex or '')
    if v.verdict == kind then rows[#rows + 1] = {claim .. ' ' .. name_of(v), sentence(v.where), why} end
  end
  return #rows == 0 and '\n\nNone.\n\n' or box('findings', table_of({'claim', 'where', 'why'}, {37, 19, 44}, rows))
end

function block.run(_, arguments) return code('$ coulomb-tether ' .. arguments .. '\n' .. run(arguments)) end

-- The sheet's quantities: "  NAME ...: {unit: U, ..., meaning: M}".
function block.symbols()
  local rows = {}
  for names, rest in read 'paper/equations.yaml':match '\nquantities:\n(.-)\n%a':gmatch '  ([^:\n]+): (%b{})' do
    local unit, meaning, list = rest:match 'unit: "?([^,"]*)', rest:match 'meaning: "?(.-)"?}$', split((names:gsub('"', '')))
    for i, name in ipairs(list) do list[i] = formula(tex_of[name]) end
    rows[#rows + 1] = {table.concat(list, ', '), unit == '-' and '' or prose(unit), prose(meaning, true)}
  end
  return table_of({'symbol', 'unit', 'meaning'}, {12, 13, 75}, rows)
end

-- From the table that the gate leaves behind.
function block.index()
  local rows = {}
  for i, g in ipairs(gate) do
    local numbers, q, name = sections[g.id].numbers, qualified(g.id), g['function']
    local links = equation_link(numbers[1])
    if #numbers > 1 then links = links .. (#numbers == 2 and ', ' or '–') .. equation_link(numbers[#numbers]) end
    rows[i] = {links .. (q and ' ' .. q or ''),
               web and '[¶](equations.html#' .. g.id .. ')' or raw_inline('\\pageref{place:' .. g.id .. '}'),
               web and '`' .. name .. '`' or raw_inline('{\\condensed ' .. name:gsub('_', '\\_') .. '}'),
               g.tests, tonumber(g.error) and formula(decimal(g.error, '2')) or g.error, g.vectors, g.verdict}
  end
  return table_of({'Eq.', web and '' or 'page', 'function', 'tests', '$E\\le$', 'vectors', 'verdict'},
                  {20, 6, 38, 7, 8, 8, 13}, rows)
end

-- Each equation with all that belongs to it.
function block.places()
  local out = {}
  local function add(text, ...) out[#out + 1] = text:format(...) end
  for _, s in ipairs(sections) do
    local g, q = gate[s.id], qualified(s.id)
    local title, tag = prose(s.title, true) .. (q and ', ' .. q or ''), span_of(s.numbers)
    local lines = s.defined and {{tex = s.defined, tag = tag}} or display(s, 'relation output let domain', {s.id})
    add('\n\n## [¶](#%s){.permalink} (%s) %s {#%s}\n\n', s.id, tag, title, s.id)
    add('%s%s%s', raw(targets(s), 'html'), equation(s, lines, q), prose(s.note or '', true))
    if s.reason then add('%s', block.printed {s.id}) end
    local said = {}  -- once where (2a), (2b) and (2c) have the same
    for _, number in ipairs(s.id:match '^eq%d+$' and s.numbers or {}) do
      local v = verdicts['equation-' .. number]
      local same = v and v.verdict .. v.claim .. (v.why or '') .. v.evidence
      if v and not said[same] then add('%s', verdict_of(v, true)) end
      said[same or ''] = true
    end
    local f = g and functions[g['function']]
    if f then
      add('%s', details(('C: <code>%s</code> in <code>%s</code>'):format(g['function'], f.path), listing(g['function'])))
    end
    local to, from, proofs = pandoc.List(), pandoc.List(), ''
    for _, step in ipairs(steps) do
      local function at(side)
        for _, entry in ipairs(step[side]) do
          if (section_of[entry] or entry:match '^[^.]*') == s.id then return true end
        end
      end
      if at 'to' then to:extend(step.from); proofs = proofs .. step_of(step, true) end
      if at 'from' then from:extend(step.to) end
    end
    if #to > 0 then add('\n\n**Comes from** %s', references(to, true)) end
    if #from > 0 then add('\n\n**Leads to** %s', references(from, true)) end
    if proofs ~= '' then add('%s', details('proof', proofs)) end
    if g and g.vectors ~= '-' then
      add('\n\n**Error and vectors.** %s %s tests, [%s golden vectors](data/%s.csv.gz). How to check yours:%s',
          tonumber(g.error) and ('The largest backward error of the function is $E=%s$ on %d random inputs;')
                                :format(decimal(g.error, '2'), errors[1].inputs) or 'Judged by correct digits;',
          g.tests, g.vectors, s.id, code('coulomb-tether conform --only ' .. s.id .. ' -- ./my-client'))
    end
  end
  return table.concat(out)
end

function block.verdicts()
  local out = {}
  for i, v in ipairs(verdicts) do out[i] = verdict_of(v, true, v.id) end
  return table.concat(out)
end

---- figures ----

-- "6a", "eq06" and "eq06.x1" are the node 6; what begins with no number, and what it has, is its own.
local function node_of(entry) return entry:match '^e?q?0*(%d+)' or entry:match '^[^.]*' end

local reached = {}
for _, step in ipairs(steps) do
  for _, entry in ipairs(step.to) do reached[node_of(entry)] = true end
end

-- The chapter's steps, and what they lead from and to. What is first is marked by its shape: no step leads to it.
local function graph_of(chapter)
  local lines, known = {}, {}
  local function node(entry)
    local name = node_of(entry)
    local number = name:match '^%d'
    local shape = reached[name] and (number and 'ellipse' or 'note') or number and 'doubleoctagon' or 'house'
    local line = ('"%s" [style=solid; URL="%s"; shape=%s]'):format(name, number and 'equations.html#eq:' .. name or '', shape)
    if not known[name] then known[name], lines[#lines + 1] = true, line end
    return name
  end
  for _, step in ipairs(steps) do
    if page_of_step[step.id] == chapter .. '.html' then
      lines[#lines + 1] = ('"%s" [URL="#step-%s"; label="%s"]'):format(step.id, step.id, (step.id:gsub('_', ' ')))
      for _, entry in ipairs(step.from) do lines[#lines + 1] = ('"%s" -> "%s" [arrowhead=none]'):format(node(entry), step.id) end
      for _, entry in ipairs(step.to) do lines[#lines + 1] = ('"%s" -> "%s"'):format(step.id, node(entry)) end
    end
  end
  return 'strict digraph { bgcolor=transparent; ranksep=0.3; nodesep=0.06; margin=0; node [fontname=Helvetica, fontsize=10, '
         .. 'height=0.1, width=0.1, margin="0.03,0.02", shape=box, style=filled, fillcolor="#eeeeee"];'
         .. table.concat(lines, ';') .. '}'
end

-- The picture within the page, without what a style sheet says better.
local function inline_svg(chapter)
  local svg = pandoc.pipe('dot', {'-Tsvg'}, graph_of(chapter)):match '<svg.*'
  for _, clutter in ipairs {'<title>.-</title>\n', '<!%-%-.-%-%->\n', ' font%-%a+="[^"]*"', ' text%-anchor="middle"',
                            ' xlink:title="[^"]*"', ' stroke="black"', '<g id="[en].-">\n', '</g>\n'} do
    svg = svg:gsub(clutter, '')
  end
  return (svg:gsub('</svg>', '</g></svg>'))
end

local function figure(caption, target)
  local kind, name = target:match '^(%a+):(.*)$'
  local source = kind == 'plot' and 'paper/figures/plot-' .. name .. '.gp' or kind == 'graph' and 'paper/' .. name .. '.md'
  if not (source and read(source)) then stop("unknown picture '%s', expected plot:NAME or graph:CHAPTER", target) end
  if caption == '' then stop("'%s' has no caption", target) end
  local id = (kind == 'graph' and 'fig:graph-' or 'fig:') .. name
  local label = labels[id] and labels[id].text  -- pages between the chapters have none
  if web then
    local named = label and 'Figure ' .. label or ''
    local drawn = kind == 'graph' and inline_svg(name) or ('<img src="plot-%s.svg" alt="%s">'):format(name, named)
    return raw('<figure id="' .. id .. '">' .. drawn .. '<figcaption>', 'html') .. (label and '**' .. named .. '.** ' or '')
           .. caption .. raw('</figcaption></figure>', 'html')
  end
  if kind == 'graph' then pandoc.pipe('dot', {'-Tpdf', '-o', build .. '/paper/graph-' .. name .. '.pdf'}, graph_of(name)) end
  local begin = ('\\begin{figure}[tbp]\\centering\\%s{%s}\\def\\thefigure{%s}\\caption{'):format(kind, name, label)
  return raw_inline(begin) .. caption .. raw_inline('}\\label{' .. id .. '}\\end{figure}')
end

---- the document ----


local woven
function woven(line)
  local keys, row = line:match '^<<rows ([^>]*)>> *(.*)$'
  if keys then
    return (keys:gsub('(%S+) *', function(key)
      local parts = split(key, '[^,]+')
      return woven((row:gsub('@(%d?)', function(i) return parts[tonumber(i)] or key end))) .. '\n'
    end):sub(1, -2))
  end
  local name, rest = line:match '^<<(%a*) *(.*)>>$'
  if name and not inline[name] then return (block[name] or stop("unknown directive '%s'", name))(split(rest), rest) end
  line = line:gsub('()<<((%a*) *(.-))>>', function(at, text, name, rest)
    if (name == 'number' or name == 'value') and select(2, line:sub(1, at):gsub('%$', '')) % 2 == 0 then
      stop("'%s' is mathematics, expected dollars around it", text)
    end
    return (inline[name] or stop("unknown directive '%s' within a line", name))(split(rest), rest)
  end)
  if line:find('<<', 1, true) then stop "'<<' without its '>>' on the same line" end
  line = line:gsub('%[([^%[%]]*)%]%(#([^%s()]+)%)', link)
  if not web then line = line:gsub('%[%]{#(ref:%w+)}', '\\phantomsection\\label{%1}') end
  local title, id = line:match '^# (.*) {#(%S+)}$'
  if web and id then return ('# %s %s {#%s}'):format(labels[id].text, title, id) end
  local caption, target = line:match '^!%[(.*)%]%(([^()]*)%)$'
  return target and figure(caption, target) or line
end

-- What the templates ask for: the version, the day, the data; for the web the pages, and those before and after this one.
local function metadata()
  local sum = output_of('$(command -v sha256sum || echo shasum -a 256) ' .. word(data .. '/datapackage.json'))
  local meta = {title = 'The Coulomb tether, checked by machine', version = run '--version':match '(%S+)%s*$',
                date = os.getenv 'CT_DATE' or '', pages = pages, fingerprint = sum:sub(1, 16)}
  for i, p in ipairs(pages) do
    if p.file == page then meta.title, meta.before, meta.after = p.title, pages[i - 1], pages[i + 1] end
  end
  return meta
end

function Reader(sources)
  local out = {}
  for _, source in ipairs(sources) do
    local number = 0
    for line in (source.text .. '\n'):gmatch '([^\n]*)\n' do
      number = number + 1
      where = source.name .. ':' .. number
      local fine, text = pcall(woven, line)
      if not fine and text ~= stop then error(text) end
      out[#out + 1] = fine and text or ''
    end
    out[#out + 1] = ''
  end
  if stops > 0 then os.exit(1) end
  local doc = pandoc.read(table.concat(out, '\n'), 'markdown-implicit_figures-fancy_lists')
  doc.meta = metadata()
  return doc:walk {
    -- In MathML upright letters are text, or each would be one of its own; and a product has its space anyway.
    Math = web and function(el) el.text = el.text:gsub('\\mathrm(%b{})', '{\\text%1}'):gsub('\\,', ' ') return el end,
    Div = not web and function(el)
      el.content:insert(1, pandoc.RawBlock('latex', '\\begin{' .. el.classes[1] .. '}'))
      el.content:insert(pandoc.RawBlock('latex', '\\end{' .. el.classes[1] .. '}'))
      return el.content
    end,
  }
end
