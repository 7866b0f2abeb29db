-- The weaver: a pandoc filter that puts what the build found in place of the directives in paper/*.md, for LaTeX and for
-- the web. What cannot be found stops it, with file and line.
--
--     sed 's/<</`&/g; s/>>/&`/g' CHAPTER.md | pandoc -f markdown-implicit_figures -L paper/weave.lua -t latex|html
--
-- From the environment: CT_PROGRAM, CT_DATA, CT_BUILD; CT_DATE, the day of the source; CT_PAGE, the page that is made.
-- A line by itself:
--   <<equation ID [only NAME ...]>>   the formula from the sheet as parsed, under its number
--   <<definition ID TEX>>             the same for a section of the sheet that has no formula
--   <<printed ID [only NAME ...]>>    what the paper has instead, and why it cannot be
--   <<function ID>>                   the function of ref/ that carries the equation's number;  <<helper NAME>>  another one
--   <<step ID>>                       a derivation step with its order, where it holds, and what is dropped
--   <<verdict ID>>                    a verdict;  <<findings VERDICT>>  a table of those that have it, and why
--   <<run ARGUMENT ...>>              a command of the program, and what it prints
--   <<show FILE [KEY]>>               a text file as it is, or what stands under KEY: in it
--   <<symbols>>, <<index>>            the quantities of the sheet; the index of equations
--   <<places>>, <<verdicts>>          for the web: each equation with all that belongs to it; all verdicts
-- Within a line, in mathematics too:
--   <<number FILE ROW COLUMN DIGITS [SCALE]>>   from data/FILE, the row by its first column, or columns: A,B
--   <<value ID OUTPUT DIGITS NAME=VALUE ...>>   what `coulomb-tether eval` finds
--   <<quote ID before|text|after>>    `text`, provided that the evidence of a verdict reads so
--   <<error ID>>                      the measured error E of a function of ref/; of `worst`: the largest
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

local chapters = {}
for path in output_of 'ls paper/[0-9]*.md':gmatch '%S+' do chapters[#chapters + 1] = path end

local function stop(text)
  for _, path in ipairs(os.getenv 'CT_PROSE' and {os.getenv 'CT_PROSE'} or chapters) do
    local number = 0
    for line in io.lines(path) do
      number = number + 1
      if line:find(current, 1, true) then
        io.stderr:write(('%s:%d: %s\n'):format(path, number, text))
        os.exit(1)
      end
    end
  end
  io.stderr:write(('%s: %s\n'):format(current, text))
  os.exit(1)
end

local function words_of(text)
  local words = {}
  for word in (text or ''):gmatch '%S+' do words[#words + 1] = word end
  return words
end

-- JSON is Lua but for brackets and colons; its strings are kept aside meanwhile.
local function json(path)
  local strings = {}
  local text = (read(path) or error('no ' .. path .. ': run make check')):gsub('\\(.)', {['"'] = '\1', ['\\'] = '\2', n = '\n'})
  text = text:gsub('"([^"]*)"', function(string)
    strings[#strings + 1] = string:gsub('\1', '"'):gsub('\2', '\\')
    return '"' .. #strings .. '"'
  end)
  text = text:gsub('%[', '{'):gsub('%]', '}'):gsub('"(%d+)": ', '[strings[%1]] = '):gsub('"(%d+)"', 'strings[%1]')
  return load('local strings = ... return ' .. text)(strings)
end

-- A line of CSV; no field of ours has a quotation mark or a line break in it.
local function csv(line)
  local fields = {}
  line = line:gsub('"([^"]*)"', function(text) return (text:gsub(',', '\0')) end)
  for field in (line .. ','):gmatch '([^,]*),' do fields[#fields + 1] = (field:gsub('%z', ',')) end
  return fields
end

-- The sheet as `coulomb-tether typeset` prints it: ID, KIND, NUMBER, NAME, TEX by tabs.
local sections, symbol, tex_of = {}, {}, {}
for line in output_of(program .. ' typeset'):gmatch '[^\n]+' do
  local id, kind, number, name, tex = line:match '^([^\t]*)\t([^\t]*)\t([^\t]*)\t([^\t]*)\t(.*)$'
  if kind == 'symbol' then
    tex_of[name] = tex
    if #name > 1 then symbol[name] = tex end  -- a letter by itself may be any word
  else
    if not sections[id] then
      sections[id] = {id = id, numbers = {}, rows = {}}
      sections[#sections + 1] = sections[id]
    end
    local s = sections[id]
    if kind == 'number' then s.numbers[#s.numbers + 1] = number
    elseif kind == 'title' or kind == 'note' or kind == 'reason' then s[kind] = tex
    else s.rows[#s.rows + 1] = {kind = kind, number = number, name = name, tex = tex} end
  end
end
symbol.stable = nil  -- a word in prose that happens to be a quantity
for name in ('pi lambda mu phi kappa epsilon rho omega cos sin tan'):gmatch '%a+' do symbol[name] = '\\' .. name .. ' ' end
symbol.uC = '\\mathrm{\\mu C}'

-- Which section has a number: of several the one that is named for it alone.
local section_of = {}
for _, s in ipairs(sections) do
  for _, number in ipairs(s.numbers) do
    for _, name in ipairs {number, (number:gsub('%a$', ''))} do
      if not section_of[name] then section_of[name] = s.id end
    end
  end
end

local functions = {}
for path in output_of 'ls ref/*.c':gmatch '%S+' do
  for text, name in ('\n' .. read(path):gsub('\n', '\n\n')):gmatch '\n(%a[^\n;]-([%w_]+)%([^;{}]-%)\n\n{\n.-\n}\n)' do
    functions[name] = {path = path, text = text:gsub('\n\n', '\n')}
  end
end

local steps, verdicts, errors, gate = {}, {}, {}, {}
for _, s in ipairs(json(build .. '/derivations.json').derivations.steps) do steps[s.id], steps[#steps + 1] = s, s end
for _, v in ipairs(json(build .. '/claims.json').claims) do verdicts[v.id], verdicts[#verdicts + 1] = v, v end
for _, e in ipairs(json(build .. '/errors.json').errors) do errors[e.id], errors[#errors + 1] = e, e end
do
  local heads
  for line in (read(build .. '/gate.csv') or error('no ' .. build .. '/gate.csv: run make check')):gmatch '[^\n]+' do
    local row = csv(line)
    if heads then
      gate[#gate + 1] = {}
      for i, head in ipairs(heads) do gate[#gate][head] = row[i] end
      gate[row[1]] = gate[#gate]
    end
    heads = heads or row
  end
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
    local digits, exponent = text:match '^([%d.]+)e([-+]?%d+)'
    local token, tex
    if digits then
      token = text:match '^[%d.]+e[-+]?%d+'
      tex = '$' .. scientific(digits, exponent) .. '$'
    elseif text:match '^%a' then
      token = text:match '^%a[%w_]*'
      tex = symbol[token] and '$' .. symbol[token] .. '$' or escape(token)
    elseif text:match '^%^%-?%d+' then
      token = text:match '^%^%-?%d+'
      tex = '$^{' .. token:sub(2) .. '}$'
    else
      token = sign[text:sub(1, 3)] and text:sub(1, 3) or sign[text:sub(1, 2)] and text:sub(1, 2) or text:sub(1, 1)
      tex = sign[token] or escape(token)
    end
    out[#out + 1] = tex
    text = text:sub(#token + 1)
  end
  return (table.concat(out):gsub('%$%$', ''))
end

local function capital(text) return text:sub(1, 1):upper() .. text:sub(2) end

-- So many significant digits, with a power of ten where the number is far from one.
local function decimal(value, digits)
  digits = math.tointeger(tonumber(digits)) or stop(("'%s' is no number of digits"):format(digits))
  local text = ('%%.%de'):format(digits - 1):format(value)
  local mantissa, exponent = text:match '^(.*)e(.*)$'
  exponent = math.tointeger(tonumber(exponent))
  if tonumber(value) ~= 0 and (exponent < -3 or exponent > 5) then return scientific(mantissa, exponent) end
  return ('%%.%df'):format(math.max(digits - 1 - exponent, 0)):format(value)
end

local links  -- below: where links lead

-- TeX of the build as inlines: for LaTeX as it is, for the web as pandoc reads it.
local function inlines(tex)
  if not web then return {pandoc.RawInline('latex', tex)} end
  tex = tex:gsub('\\textmu ?', 'µ'):gsub('\\text{µ C}', '\\mathrm{\\mu C}'):gsub('\\text{µC}', '\\mathrm{\\mu C}')
  local block = pandoc.read('\\newcommand{\\eq}[1]{\\href{\\#eq:#1}{(#1)}}\n' .. tex, 'latex').blocks[1]
  return block and pandoc.walk_block(block, links).content or {}
end

local function raw(tex) return pandoc.RawBlock('latex', tex) end
local function html(text) return pandoc.RawBlock('html', text) end

local function sequence(...)
  local all = pandoc.List()
  for _, part in ipairs {...} do all:extend(type(part) == 'string' and {pandoc.Str(part)} or part) end
  return all
end

-- What a reader opens on demand.
local function details(summary, blocks)
  local all = pandoc.List {html('<details><summary>' .. summary .. '</summary>')}
  all:extend(blocks)
  all:insert(html '</details>')
  return all
end

local function table_of(heads, widths, rows)
  local aligned, head = {}, {}
  for i, text in ipairs(heads) do aligned[i], head[i] = 'AlignLeft', {pandoc.Plain(sequence(text))} end
  for _, row in ipairs(rows) do
    for i, cell in ipairs(row) do row[i] = {pandoc.Plain(cell)} end
  end
  return pandoc.utils.from_simple_table(pandoc.SimpleTable({}, aligned, widths, head, rows))
end

---- equations ----

local qualifier = {lin = 'small angles', inv = 'inverse', exact = 'exact', roots = 'roots', flow = 'flow', rk4 = 'Runge-Kutta'}
local function qualified(id) return qualifier[id:match '^eq%d+(.*)$' or id:match '^%a+%d?'] end

-- {2a, 2b, 2c} as the reader sees it: 2a to 2c.
local function span_of(list)
  if #list < 2 then return list[1] or '' end
  return list[1] .. (#list == 2 and ', ' or '–') .. list[#list]
end

local function section(id) return sections[id] or stop(("unknown equation '%s', expected a section of paper/equations.yaml"):format(id)) end

local function only_names(words)
  if not words[3] then return nil end
  if words[3] ~= 'only' or not words[4] then stop(("expected only NAME ... after '%s'"):format(words[2])) end
  local only = {}
  for i = 4, #words do
    local found
    for _, row in ipairs(section(words[2]).rows) do found = found or row.name == words[i] end
    if not found then stop(("'%s' has no '%s', expected one of its outputs or named subexpressions"):format(words[2], words[i])) end
    only[words[i]] = true
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
  for _, row in ipairs(s.rows) do if row.kind == 'relation' then taken[row.number] = true end end
  for _, number in ipairs(s.numbers) do if not taken[number] then free[#free + 1] = number end end
  for _, row in ipairs(s.rows) do
    if kinds:find(row.kind, 1, true) and not (only and row.name ~= '' and not only[row.name]) then
      local tag = not (row.kind == 'let' or row.kind == 'domain') and (row.number ~= '' and row.number or #free > 0 and span_of(free)) or nil
      if not last or last.kind ~= row.kind or last.tag ~= tag then
        last = {kind = row.kind, tag = tag, texts = {}}
        lines[#lines + 1] = last
      end
      last.texts[#last.texts + 1] = row.tex
    end
  end
  for _, line in ipairs(lines) do
    line.tex = group(line.kind, line.texts)
    if line.kind == 'let' or line.kind == 'domain' then line.tex = (line.kind == 'let' and '\\text{with}' or '\\text{for}') .. '\\quad ' .. line.tex end
  end
  return lines
end

-- Lines that stand alone are aligned at their signs; groups have their own alignment and are centred.
local function equation_blocks(lines, suffix, targets)
  suffix = suffix and ', ' .. suffix or ''
  if web then
    local blocks = pandoc.List()
    for _, line in ipairs(lines) do
      local tex = line.tex:find('aligned', 1, true) and line.tex or line.tex:gsub('&', '')
      local inside = {pandoc.Math('DisplayMath', tex)}
      if line.tag then inside[2] = pandoc.Span(('(%s%s)'):format(line.tag, suffix), {class = 'number'}) end
      blocks:insert(pandoc.Div({pandoc.Plain(inside)}, {class = 'equation'}))
    end
    return blocks
  end
  local aligned, out = true, {}
  for _, line in ipairs(lines) do aligned = aligned and line.kind ~= 'let' and line.kind ~= 'domain' and #line.texts == 1 end
  for i, line in ipairs(lines) do
    local tex = (aligned or line.tex:find('aligned', 1, true)) and line.tex or line.tex:gsub('&', '')
    out[i] = tex .. (line.tag and '\\tag{' .. line.tag:gsub('–', '--') .. suffix .. '}' or '\\notag')
  end
  local kind = aligned and 'align' or 'gather'
  return {raw(targets .. ('\\begin{%s}\n%s\n\\end{%s}'):format(kind, table.concat(out, ' \\\\\n'), kind))}
end

-- Where a section stands for the index, and its numbers for references.
local placed = {}
local function targets(s)
  local out = placed[s.id] and '' or '\\place{' .. s.id .. '}'
  if s.id:match '^eq%d+$' then
    for i, number in ipairs(s.numbers) do
      out = out .. '\\target{' .. number .. '}'
      local base = number:match '^(%d+)%a$'
      if base and base ~= (s.numbers[i - 1] or ''):match '^%d+' then out = out .. '\\target{' .. base .. '}' end
    end
  end
  placed[s.id] = true
  return out .. '%\n'
end

local function code(text, path, language)
  if web then return {pandoc.CodeBlock(text, {class = language or 'c', title = path})} end
  return {raw(('\\begin{code}{%s}\n\\begin{lstlisting}\n%s\\end{lstlisting}\n\\end{code}'):format(escape(path), text))}
end

local function listing(name) return code(functions[name].text, functions[name].path) end

local function terminal(text)
  if web then return {pandoc.CodeBlock(text, {class = 'terminal'})} end
  return {raw('\\begin{keep}\n\\begin{lstlisting}[style=terminal]\n' .. text .. '\n\\end{lstlisting}\n\\end{keep}')}
end

---- steps and verdicts ----

-- An equation number, a section or one formula of it, or a principle or property.
local function reference(entry)
  local id, name = entry:match '^([^.]*)%.?(.*)$'
  if section_of[entry] then return '\\eq{' .. entry .. '}' end
  if not sections[id] then return escape(entry) end
  name = symbol[name] or name:gsub('_(.*)', '_{%1}')
  return '\\eq{' .. sections[id].numbers[1]:gsub('%a$', '') .. '}' .. (name == '' and '' or '~$' .. name .. '$')
end

local function references(list)
  local out = {}
  for i, entry in ipairs(list) do out[i] = reference(entry) end
  return table.concat(out, ', ')
end

local function step_blocks(s)
  local from, to = references(s.from), #s.to > 0 and ' $\\;\\rightarrow\\;$ ' .. references(s.to) or ''
  local how = (s.order and 'to order ' .. s.order or 'exactly') .. ', for ' .. prose(s.domain)
  local printed = s.printed and (s.printed.difference and 'the sides differ by a multiple of $' .. s.printed.difference .. '$' or prose(s.printed.evidence))
  local dropped = s.dropped and s.dropped ~= '' and prose(s.dropped)
  if not web then
    return {raw(('\\step{%s}{%s}{%s}{%s}{%s}'):format(escape(s.id), prose(s.title), from, to, how)
                .. (printed and '\n\\stepprinted{' .. printed .. '}' or '') .. (dropped and '\n\\stepdropped{' .. dropped .. '}' or ''))}
  end
  local inside = pandoc.List {pandoc.Para(sequence('⊢ ', {pandoc.Code(s.id)}, ': ', inlines(prose(s.title) .. '. ' .. from .. to .. '. \\emph{Proved ' .. how .. '.}')))}
  if printed then inside:insert(pandoc.Para(sequence('As printed it fails: ', inlines(printed), '.'))) end
  if dropped then inside:insert(pandoc.Para(sequence('Certified: ', inlines(dropped), '.'))) end
  if s.step.show then inside:extend(details('what was shown', {pandoc.CodeBlock(table.concat(s.step.show, '\n'))})) end
  return {pandoc.Div(inside, {class = 'step'})}
end

local function verdict_blocks(v, identifier)
  if not web then
    return {raw(('\\verdict{%s}{%s}{%s}{%s}{%s}{%s}'):format(escape(v.id), prose(capital(v.where)), v.claim_tex, v.verdict, v.how, v.evidence_tex))}
  end
  local inside = pandoc.List {pandoc.Para(sequence({pandoc.Strong(v.verdict .. ':')}, ' ', inlines(v.claim_tex), ' (', inlines(prose(capital(v.where))), ') ',
                                                   {pandoc.Link(v.id, 'verdicts.html#' .. v.id, '', {class = 'id'})}))}
  if v.why_tex then inside:insert(pandoc.Para(inlines(v.why_tex))) end
  inside:extend(details('evidence, ' .. v.how, {pandoc.Para(inlines(v.evidence_tex))}))
  return {pandoc.Div(inside, {id = identifier or '', class = 'verdict ' .. v.verdict:match '%a+'})}
end

---- within a line: each gives TeX, and whether it is mathematics ----

local inline = {}

function inline.number(words)
  local path = data .. '/' .. (words[2] or '')
  if not (words[5] and #words <= 6) then stop 'expected <<number FILE ROW COLUMN DIGITS [SCALE]>>' end
  local lines = (read(path) or stop(("no file '%s'"):format(path))):gmatch '[^\n]+'
  local column, value, found
  for i, head in ipairs(csv(lines())) do column = head == words[4] and i or column end
  if not column then stop(("'%s' has no column '%s'"):format(path, words[4])) end
  found = 0
  for line in lines do
    if line:sub(1, #words[3] + 1) == words[3] .. ',' then found, value = found + 1, csv(line)[column] end
  end
  if found ~= 1 then stop(("'%s' has %s '%s'"):format(path, found == 0 and 'no row' or found .. ' rows', words[3])) end
  if not tonumber(value) then stop(("'%s' in '%s' is no number"):format(value, path)) end
  return decimal(value * (words[6] or 1), words[5]), true
end

function inline.value(words)
  if not words[5] then stop 'expected <<value ID OUTPUT DIGITS NAME=VALUE ...>>' end
  section(words[2])
  local command = ('%s eval %s %s'):format(program, words[2], table.concat(words, ' ', 5))
  local found = (output_of(command .. ' 2>/dev/null') or ''):match('%f[%w_]' .. words[3] .. ' = (%S+)')
  return decimal(found or stop(("coulomb-tether eval %s gives no '%s'"):format(words[2], words[3])), words[4]), true
end

function inline.quote(_, text)
  local id, before, quoted, after = text:match '^quote +(%S+) ([^|]*)|([^|]+)|?([^|]*)$'
  if not id then stop 'expected <<quote ID before|text|after>>' end
  local v = verdicts[id] or stop(("unknown verdict '%s', expected an id of data/verdicts.csv"):format(id))
  if not v.evidence:find(before .. quoted .. after, 1, true) then
    stop(("the evidence of '%s' does not read '%s'"):format(id, before .. quoted .. after))
  end
  if not tonumber(quoted) then return prose(quoted), false end
  local digits, exponent = quoted:match '^(.*)e(.*)$'
  return digits and scientific(digits, exponent) or quoted, true
end

function inline.error(words)
  local found = errors[words[2]] and errors[words[2]].worst_E
  if words[2] == 'worst' then for _, e in ipairs(errors) do found = math.max(found or 0, tonumber(e.worst_E)) end end
  return decimal(found or stop(("no measured error of '%s'"):format(words[2])), 2), true
end

function inline.count(_, text)
  local what, n = text:match '^count +(.*)$', 0
  if what == 'steps' then return #steps, false end
  if what == 'verdicts' then return #verdicts, false end
  if what == 'inputs' then return errors[1].inputs, false end
  if what == 'vectors' then return output_of('cat ' .. word(data) .. "/golden/*.csv | grep -vc '^id,'"):match '%d+', false end
  local kinds = {['not decidable'] = true, refuted = true}
  for _, v in ipairs(verdicts) do
    kinds[v.verdict] = true
    if v.verdict == what or what == 'misprints' and v.id:match '^equation%-' and v.verdict == 'holds as corrected' then n = n + 1 end
  end
  if what ~= 'misprints' and not kinds[what] then
    stop(("cannot count '%s', expected steps, vectors, inputs, misprints, verdicts or a kind of verdict"):format(what))
  end
  return n, false
end

local function inline_directive(text)
  current = '<<' .. text .. '>>'
  local words = words_of(text)
  return (inline[words[1]] or stop(("unknown directive '%s' within a line"):format(words[1])))(words, text)
end

---- a line by itself: each gives blocks, and whether they are kept on a page together ----

local block = {}

function block.equation(words)
  local s = section(words[2])
  if #s.rows == 0 then stop(("'%s' has no formula in the sheet, expected <<definition %s TEX>> or <<function %s>>"):format(s.id, s.id, s.id)) end
  local only = only_names(words)
  return equation_blocks(display(s, 'relation output let' .. (only and '' or ' domain'), only), qualified(s.id), targets(s)), true
end

function block.printed(words)
  local s = section(words[2])
  if not s.reason then stop(("'%s' is printed as the sheet has it, expected an equation with a printed form"):format(s.id)) end
  local lines = display(s, 'printed', only_names(words))
  local blocks = pandoc.List {web and pandoc.Para(sequence({pandoc.Strong 'As printed. '}, inlines(prose(s.reason)))) or raw('\\asprinted{' .. prose(s.reason) .. '}')}
  blocks:extend(equation_blocks(lines, 'as printed', ''))
  return blocks, true
end

function block.definition(words, text)
  local s = section(words[2])
  local tex = text:match '^definition +%S+ +(.+)$'
  if #s.rows > 0 then stop(("'%s' has its formula in the sheet, expected <<equation %s>>"):format(s.id, s.id)) end
  if not tex then stop(('expected <<definition %s TEX>>'):format(s.id)) end
  s.defined = tex
  return equation_blocks({{tex = tex, tag = span_of(s.numbers), texts = {tex}}}, nil, targets(s)), true
end

block['function'] = function(words)
  local s = section(words[2])
  local name = gate[s.id] and gate[s.id]['function']
  if not functions[name] then stop(("no function in ref/ with the header Eq. (%s)"):format(s.numbers[1])) end
  local blocks = listing(name)
  if #s.rows == 0 and not web then table.insert(blocks, 1, raw(targets(s))) end
  return blocks, true, true
end

function block.helper(words)
  if not functions[words[2]] then stop(("unknown function '%s', expected one of ref/"):format(words[2])) end
  return listing(words[2]), true, true
end

function block.step(words)
  local s = steps[words[2]] or stop(("unknown derivation step '%s', expected one of paper/derivations.yaml"):format(words[2]))
  if s.step.finding ~= 'holds' then stop(("step '%s' does not hold: %s"):format(s.id, s.step.evidence)) end
  return step_blocks(s)
end

function block.verdict(words)
  return verdict_blocks(verdicts[words[2]] or stop(("unknown verdict '%s', expected an id of data/verdicts.csv"):format(words[2])))
end

function block.findings(_, text)
  local kind, rows = text:match '^findings +(.*)$', {}
  if not ('|holds|holds as corrected|qualified|refuted|definition|not decidable|'):find('|' .. kind .. '|', 1, true) then stop(("no verdict '%s'"):format(kind)) end
  for _, v in ipairs(verdicts) do
    if v.verdict == kind then
      rows[#rows + 1] = {sequence(inlines(v.claim_tex), ' ', {web and pandoc.Link(v.id, 'verdicts.html#' .. v.id, '', {class = 'id'})
                                  or pandoc.RawInline('latex', '{\\scriptsize\\ttfamily[' .. v.id .. ']}')}), inlines(prose(capital(v.where))), inlines(v.why_tex or '')}
    end
  end
  if #rows == 0 then return {pandoc.Para {pandoc.Str 'None.'}} end
  return {raw '\\begingroup\\footnotesize', table_of({'claim', 'where', 'why'}, {0.37, 0.19, 0.44}, rows), raw '\\endgroup'}
end

-- The build's folders stay out of what the reader sees.
function block.run(_, text)
  local arguments = text:match '^run +(.*)$'
  local printed = output_of(program .. ' ' .. arguments) or stop('coulomb-tether ' .. arguments .. ' failed')
  return terminal('$ coulomb-tether ' .. arguments .. '\n' .. printed:gsub('\n$', ''))
end

-- All of it, or from the line `  KEY:` to the next empty one.
function block.show(words)
  local text, key = read(words[2] or ''), words[3]
  if not text then stop(("no text in '%s', expected a file of the project"):format(words[2])) end
  if key then text = ('\n' .. text .. '\n\n'):match('\n(  ' .. key:gsub('%p', '%%%0') .. ':\n.-\n)\n') or stop(("no '%s:' in '%s'"):format(key, words[2])) end
  return code(text, words[2]:match '[^/]*$', 'yaml')
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

local function numbers_of(s)
  local q = qualified(s.id)
  local first, last = s.numbers[1], s.numbers[#s.numbers]
  return '\\eq{' .. first .. '}' .. (#s.numbers == 1 and '' or (#s.numbers == 2 and ', ' or '--') .. '\\eq{' .. last .. '}') .. (q and ' ' .. q or '')
end

-- From the table that the gate leaves behind.
function block.index()
  local rows = {}
  for i, g in ipairs(gate) do
    local E = tonumber(g.error) and '$' .. decimal(g.error, 2) .. '$' or g.error
    rows[i] = {inlines(numbers_of(sections[g.id])),
               web and {pandoc.Link('¶', 'equations.html#' .. g.id)} or {pandoc.RawInline('latex', '\\pageref{place:' .. g.id .. '}')},
               {web and pandoc.Code(g['function']) or pandoc.RawInline('latex', '{\\condensed ' .. escape(g['function']) .. '}')},
               {pandoc.Str(g.tests)}, inlines(E), {pandoc.Str(g.vectors)}, {pandoc.Str(g.verdict)}}
  end
  return {table_of({'Eq.', web and '' or 'page', 'function', 'tests', {pandoc.Math('InlineMath', 'E\\le')}, 'vectors', 'verdict'}, {0.17, 0.06, 0.39, 0.07, 0.08, 0.09, 0.14}, rows)}
end

-- The equations, principles and properties of `entries` that `list` has not got.
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
    local g = gate[s.id]
    local head = sequence('(' .. span_of(s.numbers) .. ') ', s.title and inlines(prose(s.title)) or '', qualified(s.id) and ', ' .. qualified(s.id) or '')
    blocks:insert(pandoc.Header(2, sequence({pandoc.Link('¶', '#' .. s.id, '', {class = 'permalink'})}, ' ', head), {id = s.id}))
    if s.id:match '^eq%d+$' then
      local anchored = {}
      for _, number in ipairs(s.numbers) do
        for _, name in ipairs {number, (number:gsub('%a$', ''))} do
          if not anchored[name] then blocks:insert(html('<a id="eq:' .. name .. '"></a>')) end
          anchored[name] = true
        end
      end
    end
    blocks:extend(equation_blocks(display(s, 'relation output let domain'), qualified(s.id)))
    if s.note then blocks:insert(pandoc.Para(inlines(prose(s.note)))) end
    if s.reason then
      local lines = display(s, 'printed')
      blocks:insert(pandoc.Para(sequence({pandoc.Strong 'As printed. '}, inlines(prose(s.reason)))))
      blocks:extend(equation_blocks(lines, 'as printed'))
    end
    local said = {}  -- once where (2a), (2b) and (2c) have the same
    for _, number in ipairs(s.numbers) do
      local v = verdicts['equation-' .. number]
      local same = v and v.verdict .. v.claim .. (v.why or '') .. v.evidence
      if v and s.id:match '^eq%d+$' and not said[same] then blocks:extend(verdict_blocks(v)) end
      if v then said[same] = true end
    end
    if g and functions[g['function']] then
      local f = functions[g['function']]
      blocks:extend(details('C: <code>' .. g['function'] .. '</code> in <code>' .. f.path .. '</code>', listing(g['function'])))
    end
    local to, from, proofs = {}, {}, pandoc.List()
    for _, step in ipairs(steps) do
      local leads, uses
      for _, entry in ipairs(step.to) do leads = leads or (section_of[entry] or entry:match '^[^.]*') == s.id end
      for _, entry in ipairs(step.from) do uses = uses or (section_of[entry] or entry:match '^[^.]*') == s.id end
      if leads then add_new(to, step.from); proofs:extend(step_blocks(step)) end
      if uses then add_new(from, step.to) end
    end
    if #to > 0 then blocks:insert(pandoc.Para(sequence({pandoc.Strong 'Comes from '}, inlines(references(to))))) end
    if #from > 0 then blocks:insert(pandoc.Para(sequence({pandoc.Strong 'Leads to '}, inlines(references(from))))) end
    if #proofs > 0 then blocks:extend(details('proof', proofs)) end
    if g and g.vectors ~= '-' then
      blocks:insert(pandoc.Para(sequence({pandoc.Strong 'Error and vectors. '}, inlines(tonumber(g.error) and 'The largest backward error of the function is $E=' .. decimal(g.error, 2)
        .. '$ on ' .. errors[1].inputs .. ' random inputs;' or 'Judged by correct digits;'), ' ' .. g.tests .. ' tests, ',
        {pandoc.Link(g.vectors .. ' golden vectors', 'data/' .. s.id .. '.csv')}, '. How to check yours:')))
      blocks:insert(pandoc.CodeBlock('coulomb-tether conform --only ' .. s.id .. ' -- ./my-client', {class = 'terminal'}))
    end
  end
  return blocks
end

function block.verdicts()
  local blocks = pandoc.List()
  for _, v in ipairs(verdicts) do blocks:extend(verdict_blocks(v, v.id)) end
  return blocks
end

---- labels: sections, figures and references, in the order of the chapters ----

local labels, pages = {}, {}
do
  local number, letters, cited = 0, 0, 0
  for _, path in ipairs(chapters) do
    local page = path:match '([^/]*)%.md$' .. '.html'
    local text = read(path)
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
  end
end

local function link(el)
  local id = el.target:match '^#(.*)$'
  if not id then return nil end
  current = '](' .. el.target .. ')'
  local number = id:match '^eq:(.*)$'
  if number then
    if not section_of[number] then stop(("unknown equation '%s', expected a number of the paper"):format(number)) end
    return web and pandoc.Link(el.content, 'equations.html#' .. id) or pandoc.RawInline('latex', '\\eq{' .. number .. '}')
  end
  if web and sections[id] then return nil end  -- an equation's own place
  local label = labels[id] or stop(("unknown reference '%s', expected a section, figure or reference"):format(id))
  local content = sequence(el.content, #el.content > 0 and '\u{a0}' or '', label.text)
  if web then return pandoc.Link(content, label.page .. '#' .. id) end
  return {pandoc.RawInline('latex', '\\hyperref[' .. id .. ']{'), pandoc.Span(content), pandoc.RawInline('latex', '}')}
end
links = {Link = link}

---- figures ----

local function figure(el)
  local kind, name = el.src:match '^(%a+):(.*)$'
  current = '](' .. el.src .. ')'
  local id = (kind == 'graph' and 'fig:graph-' or 'fig:') .. (name or '')
  local source = kind == 'plot' and 'paper/figures/plot-' .. name .. '.gp' or kind == 'graph' and 'paper/' .. name .. '.md'
  if not (source and read(source)) then stop(("unknown picture '%s', expected plot:NAME or graph:CHAPTER"):format(el.src)) end
  if #el.caption == 0 then stop(("'%s' has no caption"):format(el.src)) end
  local label = labels[id] and 'Figure ' .. labels[id].text or ''  -- those on pages between the chapters have none
  if not web then
    local blocks = pandoc.List {raw(('\\begin{figure}[htbp]\\centering\\%s{%s}\\def\\thefigure{%s}'):format(kind, name, labels[id].text))}
    blocks:insert(pandoc.Plain(sequence({pandoc.RawInline('latex', '\\caption{')}, el.caption, {pandoc.RawInline('latex', '}\\label{' .. id .. '}\\end{figure}')})))
    return blocks
  end
  local picture = kind .. '-' .. name .. '.svg'
  local drawn = kind == 'plot' and ('<img src="%s" alt="%s">'):format(picture, label)
                or read(build .. '/paper/' .. picture):gsub('^.-<svg', '<svg')
  return {html('<figure id="' .. id .. '">' .. drawn .. '<figcaption>'), pandoc.Plain(sequence({pandoc.Strong(label .. (label == '' and '' or '. '))}, el.caption)), html '</figcaption></figure>'}
end

---- the document ----

-- A paragraph of directives alone: what may not be torn apart on paper is kept together, one function a block.
local LONGEST_KEPT = 26  -- lines; longer ones would leave too much of a page empty
local function directives(para)
  local blocks, kept, has_code = pandoc.List(), nil, false
  local function flush()
    if not kept then return end
    local _, count = table.concat(kept.text):gsub('\n', '')
    local together = count + #kept.text <= LONGEST_KEPT and not web
    if together then blocks:insert(raw '\\begin{keep}') end
    blocks:extend(kept.blocks)
    if together then blocks:insert(raw '\\end{keep}') end
    kept, has_code = nil, false
  end
  for _, el in ipairs(para.content) do
    if el.t == 'Code' then
      local text = el.text:sub(3, -3)
      current = el.text
      local words = words_of(text)
      local made, keep, is_code = (block[words[1]] or stop(("unknown directive '%s'"):format(words[1])))(words, text)
      if not keep or is_code and has_code then flush() end
      if keep then
        kept = kept or {blocks = pandoc.List(), text = {}}
        kept.blocks:extend(made)
        for _, b in ipairs(made) do kept.text[#kept.text + 1] = b.text or '' end
        has_code = has_code or is_code
      else
        blocks:extend(made)
      end
    end
  end
  flush()
  return blocks
end

local function is_directives(para)
  for _, el in ipairs(para.content) do
    local name = el.t == 'Code' and el.text:match '^<<(%a*).*>>$'
    if el.t ~= 'SoftBreak' and (not name or inline[name]) then return false end
  end
  return true
end

local filter = {
  Para = function(para)
    if #para.content == 1 and para.content[1].t == 'Image' then return figure(para.content[1]) end
    if is_directives(para) then return directives(para) end
  end,
  Code = function(el)
    local text = el.text:match '^<<(.*)>>$'
    if not text then
      if el.text:find('<<', 1, true) then
        current = el.text
        stop "'<<' without its '>>' on the same line"
      end
      return nil
    end
    local tex, mathematics = inline_directive(text)
    return mathematics and pandoc.Math('InlineMath', tostring(tex)) or inlines(tostring(tex))
  end,
  Math = function(el)
    local text = el.text:gsub('`<<(.-)>>`', function(directive) return (tostring((inline_directive(directive)))) end)
    return pandoc.Math(el.mathtype, text)
  end,
  Link = link,
  Header = function(el)
    if web and el.level == 1 and labels[el.identifier] and tonumber(labels[el.identifier].text) then
      el.content = sequence(labels[el.identifier].text, ' ', el.content)
      return el
    end
  end,
  Span = function(el)
    if not web and el.identifier:match '^ref:' then return pandoc.RawInline('latex', '\\phantomsection\\label{' .. el.identifier .. '}') end
  end,
  Div = function(el)
    if web or el.classes[1] ~= 'recommended' then return nil end
    local blocks = pandoc.List {raw '\\begin{recommended}'}
    blocks:extend(el.content)
    blocks:insert(raw '\\end{recommended}')
    return blocks
  end,
}

-- What the templates ask for: the version, the day, the data; for the web the pages, and those before and after this one.
local function describe(meta)
  meta.version = output_of(program .. ' --version'):match '(%S+)%s*$'
  meta.date = os.getenv 'CT_DATE' or ''
  meta.fingerprint = output_of('sha256sum ' .. word(data .. '/datapackage.json')):sub(1, 16)
  local here
  for i, page in ipairs(pages) do
    if page.file == os.getenv 'CT_PAGE' then here = i end
  end
  meta.pages = pages
  meta.before, meta.after = pages[(here or 1) - 1], here and pages[here + 1]
  meta.title = here and pages[here].title or 'The Coulomb tether, checked by machine'
  return meta
end

function Pandoc(doc)
  doc.blocks = pandoc.walk_block(pandoc.Div(doc.blocks), {Para = filter.Para}).content
  doc.blocks = pandoc.walk_block(pandoc.Div(doc.blocks), {Code = filter.Code, Math = filter.Math, Link = filter.Link, Span = filter.Span, Div = filter.Div,
                                                              Header = filter.Header}).content
  doc.meta = describe(doc.meta)
  return doc
end
